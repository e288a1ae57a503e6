#include "scene/Voxels.h"

#include <algorithm>
#include <cmath>

namespace limpid {

namespace {

/// A triangle cut by at most four planes, in cells.
struct Polygon {
    std::array<glm::dvec3, 8> corner;
    int count = 0;

    /// First and last cell that it reaches along an axis.
    glm::ivec2 cells(int axis) const {
        if (count == 0) return {0, -1};
        double low = 1e300, high = -1e300;
        for (int i = 0; i < count; ++i) {
            low = std::min(low, corner[std::size_t(i)][axis]);
            high = std::max(high, corner[std::size_t(i)][axis]);
        }
        return glm::clamp(glm::ivec2(glm::floor(glm::dvec2(low, high))), 0, Voxels::side - 1);
    }
};

/// The part where coordinate `axis` is at least `limit` (`way` 1) or at most (`way` -1).
Polygon cut(const Polygon& polygon, int axis, double limit, double way) {
    Polygon kept;
    for (int i = 0; i < polygon.count; ++i) {
        const glm::dvec3& from = polygon.corner[std::size_t(i)];
        const glm::dvec3& to = polygon.corner[std::size_t((i + 1) % polygon.count)];
        const double fromIn = way * (from[axis] - limit), toIn = way * (to[axis] - limit);
        if (fromIn >= 0) kept.corner[std::size_t(kept.count++)] = from;
        if ((fromIn >= 0) != (toIn >= 0))
            kept.corner[std::size_t(kept.count++)] = from + (to - from) * (fromIn / (fromIn - toIn));
    }
    return kept;
}

/// The part within cell `at` of an axis, both faces included.
Polygon slab(const Polygon& polygon, int axis, int at) {
    return cut(cut(polygon, axis, at, 1), axis, at + 1, -1);
}

} // namespace

void Voxels::add(const std::array<glm::dvec3, 3>& triangle) {
    Polygon whole;
    for (const glm::dvec3& p : triangle)
        whole.corner[std::size_t(whole.count++)] =
            glm::clamp((p - _box.min) / _box.size(), 0.0, 1.0) * double(side);
    const glm::ivec2 columns = whole.cells(0);
    for (int x = columns[0]; x <= columns[1]; ++x) {
        const Polygon column = slab(whole, 0, x);
        const glm::ivec2 rows = column.cells(2);
        for (int z = rows[0]; z <= rows[1]; ++z) {
            const Polygon piece = slab(column, 2, z);
            const glm::ivec2 heights = piece.cells(1);
            for (int y = heights[0]; y <= heights[1]; ++y)
                _solid[index(glm::ivec3(x, y, z) + 1)] = true;
        }
    }
}

} // namespace limpid
