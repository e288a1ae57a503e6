#pragma once
#include <optional>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "plan/FlatWater.h"
#include "plan/LightFrame.h"
#include "plan/MapPlan.h"
#include "plan/Sides.h"
#include "scene/Scene.h"

namespace limpid {

struct PlannedLight {
    bool enters = false;  ///< the water, from above
    LightFrameData frame; ///< m from the plan's origin
    double farthest = 1;  ///< m of water to the farthest receiver, at most; of a light that enters
    std::optional<WaterPatch>
        pointLightPatch; ///< for a point light close to the water (plan/PointLightPatch.h)
};

/// All that follows from a scene without a GPU: where what is to be computed, and what need not be. A value;
/// whoever computes light for the same scene has the same. It does not depend on time, nor on how caustics
/// are computed.
struct Plan {
    glm::dvec3 origin{0};                   ///< in the world, m: what single precision is relative to
    WaterPatch patch;                       ///< of the surface, in the world
    std::vector<PlannedReceiver> receivers; ///< as the scene has them
    std::vector<glm::dvec3> dry;            ///< corners of what stands out of the water, in the world, m
    SideBounds sides;                       ///< of all receivers
    std::vector<PlannedLight> lights;       ///< as the scene has them
    std::vector<PlannedMap> maps;           ///< as planMaps has them, boxes in the world
};

/// Every receiver has a mesh. `before`: of any plan; what a mesh alone decides is taken from those of the
/// same mesh, and comes out the same.
Plan planOf(const Scene& scene, std::span<const PlannedReceiver> before = {});

} // namespace limpid
