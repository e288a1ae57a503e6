#pragma once
#include <span>
#include <vector>

#include "core/OrientedBox.h"
#include "reference/SceneGeometry.h"

namespace limpid {

/// The surface that the texels of one finished map show, for placing what lands on it. A texel shows the face
/// at its middle, as far as it goes on within the texel; that is also what its light is summed for
/// (levelmap/Coverage.h).
struct ShownSurface {
    int receiver = 0;
    int facing = 0; ///< 0 the map along the light, k a side map
    reference::FaceSorting faces;
    TexelFrame frame;                ///< m from the scene's origin
    double level = 0;                ///< of the water, y from the scene's origin, m
    std::span<const float> position; ///< RGBA a texel: m from the scene's origin; 1 where there is a receiver
    std::span<const float> normal;   ///< RGB a texel: unit, geometric, facing the box's top
    std::span<const float> coverage; ///< a texel: share that the shown surface covers, [0, 1]
    /// A texel: share of the light that the method takes, [0, 1]; empty where it takes all.
    std::vector<float> taken;

    /// The share of what lands at `hit` that the map takes, [0, 1]: 0 where no texel shows the place. The hit
    /// is on `receiver`.
    double share(const reference::Hit& hit, const reference::SceneGeometry& geometry) const;

  private:
    bool isSeen(const glm::dvec3& local, double depth, const reference::SceneGeometry& geometry) const;
};

} // namespace limpid
