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
    double deposited = 0;             ///< Σ irradiance · surface area, W, mean of R, G and B
};

/// Waits for the GPU.
MapData readMaps(const ReceiverMaps& maps, const glm::dvec3& origin);

} // namespace limpid
