#pragma once
#include <span>

#include <glm/glm.hpp>

#include "core/ShaderData.h"
#include "plan/FlatWater.h"
#include "scene/Scene.h"

namespace limpid {

/// A light over the water, as shaders read it. Positions in m from the scene's origin. Made without more, it
/// shines straight down.
struct LightFrameData : gpu::LightFrame {
    LightFrameData();
    bool operator==(const LightFrameData& other) const;
};
LightFrameData lightFrame(const Light& light, const Water& water, const glm::dvec3& origin);

/// The part of the flat surface where the mean light enters that reaches any of `points` (submerged, in the
/// world), as LightFrameData wants it: x, z of a corner and extents, m from the scene's origin. A margin
/// keeps the outermost points inside.
glm::vec4 sceneDepthRect(const Light& light, const Water& water, std::span<const glm::dvec3> points,
                         const glm::dvec3& origin);

/// The part of the flat surface that things above it (`dry` points, in the world) may shade, as
/// LightFrameData wants it; extents 0 if there are none. No further than half a patch around the patch.
glm::vec4 surfaceShadowRect(const Light& light, const Water& water, const WaterPatch& patch,
                            std::span<const glm::dvec3> dry, const glm::dvec3& origin);

} // namespace limpid
