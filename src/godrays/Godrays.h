#pragma once
#include <span>

#include <glm/glm.hpp>

#include "gl/Handles.h"
#include "gl/Program.h"
#include "levelmap/ReceiverGeometry.h"
#include "levelmap/SceneDepthMap.h"
#include "plan/FlatWater.h"
#include "scene/Scene.h"
#include "water/Beams.h"

namespace limpid {

/// A light that enters the water.
struct GodraySource {
    const Beams& beams;
    const SceneDepth& sceneDepth;
    const Light& light;
    double farthest; ///< m of water to the farthest receiver, at most
};

/// Where from and how large the picture is.
struct GodrayCamera {
    glm::mat4 viewProjection; ///< depth from 1 near by to 0 far away; w: m along the view
    glm::vec3 position;       ///< under water, m from the scene's origin
    glm::ivec2 size;          ///< pixels
};

/// What every way to draw light in the water starts from.
struct GodrayInputs {
    const Scene& scene;
    const WaterMesh& surface;
    const WaterPatch& patch; ///< that the surface covers, in the world
    const glm::dvec3& origin;
    std::span<const ReceiverGeometry> receivers;
    std::span<const GodraySource> sources;
    GodrayCamera camera;
};

/// Pixels of the target for a picture of `size`.
glm::ivec2 godrayTargetSize(glm::ivec2 size, double scale);

/// gpu::GodrayFrame of one light.
gl::Buffer godrayFrame(gl::Ledger& ledger, const GodrayInputs& inputs, const GodraySource& source);

/// Gives a program what it asks of shaders/water/photon_ray.glsl, scene_depth.glsl and surface_shadow.glsl:
/// a photon grid as the settings have it over the whole patch.
void bindPhotons(const gl::Program& program, const GodrayInputs& inputs, const GodraySource& source);

/// m that a light is followed: until e^-`mostExtinction` of it is left in the clearest channel, or it has
/// left all that a camera among the receivers can see.
double godrayReach(const GodrayInputs& inputs, const GodraySource& source, double mostExtinction);

} // namespace limpid
