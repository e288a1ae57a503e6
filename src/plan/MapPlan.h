#pragma once
#include <memory>
#include <span>
#include <vector>

#include "core/OrientedBox.h"
#include "plan/Facings.h"
#include "plan/FlatWater.h"
#include "scene/Scene.h"

/// Which maps a scene has and how each of them looks at its receiver. Decided without a GPU, so that whatever
/// else computes light for the same scene does it on the very same texels.
namespace limpid {

struct PlannedReceiver {
    std::shared_ptr<const Mesh> mesh; ///< the receiver's
    std::shared_ptr<const HostMesh> host;
    bool closed = false;               ///< whether that encloses a solid (enclosesSolid)
    bool solid = false;                ///< and is wound outwards as far as signs of scale can say
    Bounds bounds;                     ///< m from the scene's origin
    Bounds wet;                        ///< of its part below the level, in the world, m
    std::vector<glm::dvec3> submerged; ///< corners of that part (pointsOfSide), in the world, m
};

struct PlannedMap {
    int receiver = 0;
    int light = 0;
    int facing = 0;                         ///< 0 the map along the light; k the side map of axis k - 1
    std::shared_ptr<const Facings> facings; ///< of this receiver and light
    OrientedBox box;                        ///< in the world
    DepthGradients gradients;
    bool inReach = true; ///< whether any of the water's light may come to the receiver

    bool operator==(const PlannedMap& other) const; ///< facings by value
};

/// One for each light and each receiver that reaches into the water, lights outermost; after it, one for each
/// of its side maps. `receivers`: as the scene has them.
std::vector<PlannedMap> planMaps(const Scene& scene, std::span<const PlannedReceiver> receivers,
                                 const WaterPatch& patch);

/// Texels on the longer side of a map. Side maps are lit by beams that run along them, each over many
/// texels; finer than a quarter of the water's quads there is nothing to see in them.
int mapSize(const Scene& scene, const WaterPatch& patch, const OrientedBox& box, int facing);

/// What positions in single precision are relative to, m: zero unless the scene is far from it.
glm::dvec3 sceneOrigin(const Scene& scene);

} // namespace limpid
