#pragma once
#include <vector>

#include <glm/glm.hpp>

#include "engine/Engine.h"

namespace limpid {

/// The finished maps of a receiver and a light, off the GPU. Rows from the top of the box.
struct MapData {
    glm::ivec2 size{0};
    std::vector<float> irradiance; ///< RGB, W/m² on the receiver's own surface, 0 where there is none
    std::vector<float> position;   ///< RGBA: m from the scene's origin; 1 where the texel sees the receiver
    std::vector<float> normal;     ///< RGB: unit, geometric, facing the box's top
    std::vector<float> normalDotAxis; ///< |n·V|, 0 where there is no receiver
    std::vector<float> coverage; ///< share of the texel that its surface covers, [0, 1]; 1 unless asked for
    double deposited = 0;        ///< Σ irradiance · surface area, W, mean of R, G and B
};

/// Texels that light reaches, by reference plane, over all requested planes of the box: what smart slicing
/// decides by. Empty without a level map. Waits for the GPU.
std::vector<std::uint32_t> planeHistogram(const LevelMap& map);

/// Waits for the GPU. `coverage`: Engine::coverage, by which `deposited` counts texels at rims by the part of
/// them that the receiver covers; null: whole.
MapData readMaps(const MapWork& maps, const glm::dvec3& origin, const gl::Texture* coverage = nullptr);

} // namespace limpid
