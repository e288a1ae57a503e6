#pragma once
#include <cmath>
#include <cstdint>

#include <glm/glm.hpp>

#include "reference/Random.h"

namespace limpid::reference {

/// One jittered subdivision of the water's patch into rectangles. Under a point light they are narrow at its
/// foot, so that a point light close to the water is met as finely as one far away.
struct CellGrid {
    glm::dvec2 min{0}, max{1}; ///< x and z, m from the origin
    glm::ivec2 count{1};       ///< cells
    std::uint64_t seed = 0;    ///< another one, another subdivision
    bool stretched = false;
    glm::dvec2 foot{0}; ///< of the point light
    double height = 1;  ///< of the point light, m

    /// Line `i` in [0, count] of an axis. The outer ones stay where the patch ends; each other one moves
    /// within its own share, so that they keep their order.
    double line(int axis, int i) const {
        if (i <= 0) return min[axis];
        if (i >= count[axis]) return max[axis];
        const double jitter = unit(mixed(seed + std::uint64_t(axis), std::uint64_t(i))) - 0.5;
        const double s = (i + 0.7 * jitter) / count[axis];
        if (!stretched) return glm::mix(min[axis], max[axis], s);
        const double low = std::asinh((min[axis] - foot[axis]) / height),
                     high = std::asinh((max[axis] - foot[axis]) / height);
        return foot[axis] + height * std::sinh(glm::mix(low, high, s));
    }
};

} // namespace limpid::reference
