#pragma once
#include <vector>

#include <glm/glm.hpp>

namespace limpid {

/// Linear radiance, RGB floats, W/(m² sr), rows from the top.
struct Picture {
    glm::ivec2 size{0}; ///< pixels
    std::vector<float> rgb;
};

} // namespace limpid
