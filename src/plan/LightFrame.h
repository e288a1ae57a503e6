#pragma once
#include <span>

#include <glm/glm.hpp>

#include "plan/FlatWater.h"
#include "scene/Scene.h"

namespace limpid {

/// A light over the water, as shaders/water/light.glsl reads it (std140). Positions in m from the scene's
/// origin.
struct LightFrameData {
    glm::vec4 position{0};
    glm::vec4 direction{0, -1, 0, 0};
    glm::vec4 refracted{0, -1, 0, 0};
    glm::vec4 sceneDepthRect{0, 0, 1, 1};
    glm::vec4 surface{0, 1.333, 0, 0};
    glm::vec4 surfaceShadowRect{0};
    glm::vec4 cone{-2, -3, 0, 0};

    bool operator==(const LightFrameData&) const = default;
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
