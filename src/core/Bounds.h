#pragma once
#include <glm/glm.hpp>

namespace limpid {

/// A box along the axes, m; empty (min > max) until something is added.
struct Bounds {
    glm::dvec3 min{1e300};
    glm::dvec3 max{-1e300};

    bool empty() const { return min.x > max.x; }
    void add(const glm::dvec3& p) { min = glm::min(min, p), max = glm::max(max, p); }
    glm::dvec3 center() const { return 0.5 * (min + max); }
    glm::dvec3 size() const { return max - min; }
    bool operator==(const Bounds&) const = default;
    /// Bit c of `i`, [0, 8), says at which end of axis c.
    glm::dvec3 corner(int i) const {
        return {i & 1 ? max.x : min.x, i & 2 ? max.y : min.y, i & 4 ? max.z : min.z};
    }
};

} // namespace limpid
