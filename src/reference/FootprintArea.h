#pragma once
#include <algorithm>
#include <array>
#include <cmath>

#include <glm/glm.hpp>

namespace limpid::reference {

/// A convex polygon of at most seven corners: a triangle cut with a square.
struct Polygon {
    std::array<glm::dvec2, 8> corner;
    int count = 0;

    double area() const {
        double twice = 0;
        for (int i = 2; i < count; ++i) {
            const glm::dvec2 a = corner[std::size_t(i - 1)] - corner[0],
                             b = corner[std::size_t(i)] - corner[0];
            twice += a.x * b.y - a.y * b.x;
        }
        return 0.5 * std::abs(twice);
    }
    /// A point inside; the mean of the corners.
    glm::dvec2 middle() const {
        glm::dvec2 sum(0);
        for (int i = 0; i < count; ++i)
            sum += corner[std::size_t(i)];
        return sum / double(std::max(count, 1));
    }
};

/// The part of a polygon where coordinate `axis` is at least `limit` (`side` 1) or at most (`side` -1).
/// Sutherland and Hodgman 1974.
inline Polygon cut(const Polygon& polygon, int axis, double limit, double side) {
    Polygon kept;
    if (polygon.count == 0) return kept;
    glm::dvec2 before = polygon.corner[std::size_t(polygon.count - 1)];
    double beforeIn = side * (before[axis] - limit);
    for (int i = 0; i < polygon.count; ++i) {
        const glm::dvec2 here = polygon.corner[std::size_t(i)];
        const double in = side * (here[axis] - limit);
        if ((in >= 0) != (beforeIn >= 0)) {
            glm::dvec2 crossing = before + (here - before) * (beforeIn / (beforeIn - in));
            crossing[axis] = limit;
            kept.corner[std::size_t(kept.count++)] = crossing;
        }
        if (in >= 0) kept.corner[std::size_t(kept.count++)] = here;
        before = here;
        beforeIn = in;
    }
    return kept;
}

/// Calls `visit(x, y, area, middle)` for every unit square [x, x + 1] × [y, y + 1] of the grid
/// [0, size.x] × [0, size.y] that the triangle overlaps: the exact area of the overlap and a point in it.
/// Returns the area within the grid.
template <typename Visit>
double overlaps(const std::array<glm::dvec2, 3>& triangle, glm::ivec2 size, Visit&& visit) {
    const glm::dvec2 low = glm::min(glm::min(triangle[0], triangle[1]), triangle[2]),
                     high = glm::max(glm::max(triangle[0], triangle[1]), triangle[2]);
    const auto cell = [](double at, int count) {
        return int(std::clamp(std::floor(at), -1.0, double(count)));
    };
    const Polygon whole{{triangle[0], triangle[1], triangle[2]}, 3};
    double sum = 0;
    for (int y = std::max(cell(low.y, size.y), 0); y <= std::min(cell(high.y, size.y), size.y - 1); ++y) {
        const Polygon row = cut(cut(whole, 1, y, 1), 1, y + 1, -1);
        if (row.count < 3) continue;
        double left = row.corner[0].x, right = left;
        for (int i = 1; i < row.count; ++i) {
            left = std::min(left, row.corner[std::size_t(i)].x);
            right = std::max(right, row.corner[std::size_t(i)].x);
        }
        for (int x = std::max(cell(left, size.x), 0); x <= std::min(cell(right, size.x), size.x - 1); ++x) {
            const Polygon piece = cut(cut(row, 0, x, 1), 0, x + 1, -1);
            const double area = piece.area();
            if (!(area > 0)) continue;
            sum += area;
            visit(x, y, area, piece.middle());
        }
    }
    return sum;
}

} // namespace limpid::reference
