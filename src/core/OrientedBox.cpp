#include "core/OrientedBox.h"

#include <algorithm>
#include <cmath>

namespace limpid {

namespace {

double cross(const glm::dvec2& a, const glm::dvec2& b) {
    return a.x * b.y - a.y * b.x;
}

struct Rectangle {
    glm::dvec2 axis{1, 0}; ///< unit; the other one is it turned by 90°
    glm::dvec2 min{0}, max{0};
    double area() const { return (max.x - min.x) * (max.y - min.y); }
};

Rectangle around(const std::vector<glm::dvec2>& hull, const glm::dvec2& axis) {
    Rectangle r{axis, glm::dvec2(1e300), glm::dvec2(-1e300)};
    for (const glm::dvec2& p : hull) {
        const glm::dvec2 q(glm::dot(p, axis), cross(axis, p));
        r.min = glm::min(r.min, q);
        r.max = glm::max(r.max, q);
    }
    return r;
}

/// The smallest rectangle around a convex polygon has a side along one of its edges.
Rectangle smallest(const std::vector<glm::dvec2>& hull) {
    Rectangle best = around(hull, {1, 0});
    for (std::size_t i = 0; i < hull.size(); ++i) {
        const glm::dvec2 edge = hull[(i + 1) % hull.size()] - hull[i];
        const double length = glm::length(edge);
        if (length <= 0) continue;
        const Rectangle r = around(hull, edge / length);
        // The slack keeps the axes put where turns differ by rounding only.
        if (r.area() < best.area() * (1 - 1e-9)) best = r;
    }
    return best;
}

} // namespace

std::vector<glm::dvec2> convexHull(std::vector<glm::dvec2> points) {
    const auto less = [](const glm::dvec2& a, const glm::dvec2& b) {
        return a.x < b.x || (a.x == b.x && a.y < b.y);
    };
    std::sort(points.begin(), points.end(), less);
    points.erase(std::unique(points.begin(), points.end()), points.end());
    if (points.size() < 3) return points;
    std::vector<glm::dvec2> hull;
    for (const bool upper : {false, true}) {
        const std::size_t start = hull.size();
        for (std::size_t i = 0; i < points.size(); ++i) {
            const glm::dvec2& p = upper ? points[points.size() - 1 - i] : points[i];
            while (hull.size() >= start + 2 &&
                   cross(hull.back() - hull[hull.size() - 2], p - hull[hull.size() - 2]) <= 0)
                hull.pop_back();
            hull.push_back(p);
        }
        hull.pop_back();
    }
    return hull;
}

OrientedBox tightBox(std::span<const glm::dvec3> points, const glm::dvec3& direction) {
    const glm::dvec3 t = glm::normalize(direction);
    const glm::dvec3 helper = std::abs(t.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 0, 1);
    const glm::dvec3 right = glm::normalize(helper - glm::dot(helper, t) * t);
    const glm::dvec3 down = glm::cross(t, right);
    std::vector<glm::dvec2> footprint;
    double near = 1e300, far = -1e300;
    footprint.reserve(points.size());
    for (const glm::dvec3& p : points) {
        footprint.emplace_back(glm::dot(p, right), glm::dot(p, down));
        near = std::min(near, glm::dot(p, t));
        far = std::max(far, glm::dot(p, t));
    }
    const Rectangle r = smallest(convexHull(std::move(footprint)));
    const glm::dvec3 first = r.axis.x * right + r.axis.y * down;
    const glm::dvec3 second = glm::cross(t, first);
    const glm::dvec3 base = 0.5 * (r.min.x + r.max.x) * first + 0.5 * (r.min.y + r.max.y) * second + near * t;
    const glm::dvec2 side = r.max - r.min;

    OrientedBox box;
    box.t = t;
    box.u = first, box.w = second, box.extent = {side.x, side.y, far - near};
    const glm::dvec3 turns[] = {first, second, -first, -second};
    for (int i = 1; i < 4; ++i) {
        if (turns[i].x <= box.u.x + 1e-9) continue;
        box.u = turns[i];
        box.w = glm::cross(t, box.u);
        box.extent = i % 2 ? glm::dvec3(side.y, side.x, far - near) : glm::dvec3(side.x, side.y, far - near);
    }
    box.corner = base - 0.5 * box.extent.x * box.u - 0.5 * box.extent.y * box.w;
    return box;
}

TexelFrame texelFrame(const OrientedBox& tight, int mapSize) {
    TexelFrame frame;
    frame.box = tight;
    const double longer = std::max({tight.extent.x, tight.extent.y, 1e-6 * tight.extent.z, 1e-12});
    frame.texel = longer / mapSize;
    frame.flat = tight.extent.z < 1e-6 * longer;
    frame.size = {std::clamp(int(std::ceil(tight.extent.x / frame.texel - 1e-6)), 1, mapSize),
                  std::clamp(int(std::ceil(tight.extent.y / frame.texel - 1e-6)), 1, mapSize)};
    const glm::dvec3 grown(frame.size.x * frame.texel, frame.size.y * frame.texel,
                           std::max(tight.extent.z, 1e-4 * longer));
    const glm::dvec3 more = 0.5 * (grown - tight.extent);
    frame.box.corner = tight.point(-more);
    frame.box.extent = grown;
    return frame;
}

glm::dmat4 TexelFrame::worldToTexture() const {
    const OrientedBox& b = box;
    glm::dmat4 m(1);
    const glm::dvec3 axes[] = {b.u / b.extent.x, b.w / b.extent.y, b.t / b.extent.z};
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column)
            m[column][row] = axes[row][column];
        m[3][row] = -glm::dot(axes[row], b.corner);
    }
    return m;
}

} // namespace limpid
