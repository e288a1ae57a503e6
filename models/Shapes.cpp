#include "Shapes.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace limpid::models {

namespace {

// Two rings of `sides` positions each, the first at `low`, the second at `high`.
void joinRings(Shell& shell, std::uint32_t low, std::uint32_t high, std::uint32_t sides) {
    for (std::uint32_t side = 0; side < sides; ++side) {
        const std::uint32_t next = (side + 1) % sides;
        shell.indices.insert(shell.indices.end(),
                             {low + side, low + next, high + next, low + side, high + next, high + side});
    }
}

void closeRing(Shell& shell, std::uint32_t ring, std::uint32_t sides, const glm::dvec3& pole, bool below) {
    const auto middle = static_cast<std::uint32_t>(shell.positions.size());
    shell.positions.push_back(pole);
    for (std::uint32_t side = 0; side < sides; ++side) {
        const std::uint32_t here = ring + side;
        const std::uint32_t next = ring + (side + 1) % sides;
        shell.indices.insert(shell.indices.end(), {middle, below ? next : here, below ? here : next});
    }
}

// Clockwise seen from above, so that rings joined upward face outward.
void appendCircle(Shell& shell, const glm::dvec2& point, int sides) {
    for (int side = 0; side < sides; ++side) {
        const double angle = -glm::two_pi<double>() * side / sides;
        shell.positions.emplace_back(point.x * std::cos(angle), point.y, point.x * std::sin(angle));
    }
}

std::uint32_t size(const Shell& shell) {
    return static_cast<std::uint32_t>(shell.positions.size());
}

void appendLayer(Shell& shell, const std::vector<glm::dvec2>& polygon, double z) {
    for (const glm::dvec2& p : polygon)
        shell.positions.emplace_back(p, z);
}

// The triangles of a cap made of the layer's own positions.
void appendCap(Shell& shell, std::uint32_t layer, const std::vector<std::uint32_t>& triangles, bool below) {
    for (std::size_t i = 0; i < triangles.size(); i += 3)
        shell.indices.insert(shell.indices.end(),
                             {layer + triangles[i], layer + triangles[i + (below ? 2 : 1)],
                              layer + triangles[i + (below ? 1 : 2)]});
}

} // namespace

glm::dvec3 along(const std::vector<glm::dvec3>& points, double t) {
    const int last = static_cast<int>(points.size()) - 1;
    const double scaled = std::clamp(t, 0.0, 1.0) * last;
    const int span = std::min(static_cast<int>(scaled), last - 1);
    const auto point = [&](int i) -> glm::dvec3 {
        if (i < 0) return 2.0 * points.front() - points[1];
        if (i > last) return 2.0 * points.back() - points[static_cast<std::size_t>(last - 1)];
        return points[static_cast<std::size_t>(i)];
    };
    const double s = scaled - span;
    const glm::dvec3 a = point(span - 1), b = point(span), c = point(span + 1), d = point(span + 2);
    return b + 0.5 * s * ((c - a) + s * ((2.0 * a - 5.0 * b + 4.0 * c - d) + s * (3.0 * (b - c) + d - a)));
}

Shell lathe(const std::vector<glm::dvec2>& outline, int sides) {
    const bool ring = outline.front().x > 0.0;
    const auto count = static_cast<std::uint32_t>(sides);
    Shell shell;
    for (std::size_t i = ring ? 0 : 1; i + (ring ? 0 : 1) < outline.size(); ++i)
        appendCircle(shell, outline[i], sides);
    const std::uint32_t rings = size(shell) / count;
    for (std::uint32_t i = 0; i + 1 < rings; ++i)
        joinRings(shell, i * count, (i + 1) * count, count);
    if (ring) {
        joinRings(shell, (rings - 1) * count, 0, count);
    } else {
        closeRing(shell, 0, count, {0.0, outline.front().y, 0.0}, true);
        closeRing(shell, (rings - 1) * count, count, {0.0, outline.back().y, 0.0}, false);
    }
    return shell;
}

Shell smoothLathe(const std::vector<glm::dvec2>& outline, int steps, int sides) {
    std::vector<glm::dvec3> points;
    for (const glm::dvec2& p : outline)
        points.emplace_back(p, 0.0);
    const int pieces = (static_cast<int>(outline.size()) - 1) * steps;
    std::vector<glm::dvec2> fine{outline.front()};
    for (int i = 1; i < pieces; ++i) {
        const glm::dvec3 p = along(points, double(i) / pieces);
        fine.emplace_back(std::max(p.x, 1e-4), p.y);
    }
    fine.push_back(outline.back());
    return lathe(fine, sides);
}

Shell globe(const glm::dvec3& centre, double radius, int rows, int sides) {
    std::vector<glm::dvec2> outline{{0.0, -radius}};
    for (int row = 1; row < rows; ++row) {
        const double angle = glm::pi<double>() * row / rows;
        outline.emplace_back(radius * std::sin(angle), -radius * std::cos(angle));
    }
    outline.emplace_back(0.0, radius);
    Shell shell = lathe(outline, sides);
    for (glm::dvec3& p : shell.positions)
        p = centre + glm::dvec3{p.x, -p.z, p.y};
    return shell;
}

Shell rod(const std::vector<glm::dvec3>& points, const std::vector<double>& radii, int steps, int sides) {
    std::vector<glm::dvec3> thickness;
    for (double radius : radii)
        thickness.emplace_back(radius, 0.0, 0.0);
    const int rings = (static_cast<int>(points.size()) - 1) * steps;
    Shell shell;
    glm::dvec3 across{0.0};
    for (int i = 0; i <= rings; ++i) {
        const double t = double(i) / rings;
        const glm::dvec3 ahead = glm::normalize(along(points, t + 1e-4) - along(points, t - 1e-4));
        // The frame turns as little as it can from ring to ring.
        if (i == 0) across = std::abs(ahead.y) < 0.9 ? glm::dvec3{0.0, 1.0, 0.0} : glm::dvec3{1.0, 0.0, 0.0};
        across = glm::normalize(across - glm::dot(across, ahead) * ahead);
        const glm::dvec3 side = glm::cross(ahead, across);
        const double radius = along(thickness, t).x;
        for (int corner = 0; corner < sides; ++corner) {
            const double angle = glm::two_pi<double>() * corner / sides;
            shell.positions.push_back(along(points, t) +
                                      radius * (std::cos(angle) * across + std::sin(angle) * side));
        }
    }
    const auto count = static_cast<std::uint32_t>(sides);
    for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(rings); ++i)
        joinRings(shell, i * count, (i + 1) * count, count);
    closeRing(shell, 0, count, points.front(), true);
    closeRing(shell, static_cast<std::uint32_t>(rings) * count, count, points.back(), false);
    return shell;
}

Shell slab(const std::vector<glm::dvec2>& polygon, double z0, double z1, double bevel) {
    const auto count = static_cast<std::uint32_t>(polygon.size());
    const std::vector<std::uint32_t> triangles = triangulated(polygon);
    const std::vector<glm::dvec2> cap = bevel > 0.0 ? inset(polygon, bevel) : polygon;
    Shell shell;
    if (bevel > 0.0) appendLayer(shell, cap, z0);
    appendLayer(shell, polygon, z0 + bevel);
    appendLayer(shell, polygon, z1 - bevel);
    if (bevel > 0.0) appendLayer(shell, cap, z1);
    const std::uint32_t layers = size(shell) / count;
    for (std::uint32_t i = 0; i + 1 < layers; ++i)
        joinRings(shell, i * count, (i + 1) * count, count);
    appendCap(shell, 0, triangles, true);
    appendCap(shell, (layers - 1) * count, triangles, false);
    return shell;
}

Shell block(const glm::dvec3& low, const glm::dvec3& high, double bevel) {
    if (bevel == 0.0)
        return slab({{low.x, low.y}, {high.x, low.y}, {high.x, high.y}, {low.x, high.y}}, low.z, high.z);
    const double b = bevel;
    return slab({{low.x + b, low.y},
                 {high.x - b, low.y},
                 {high.x, low.y + b},
                 {high.x, high.y - b},
                 {high.x - b, high.y},
                 {low.x + b, high.y},
                 {low.x, high.y - b},
                 {low.x, low.y + b}},
                low.z, high.z, b);
}

Shell cushion(const glm::dvec3& centre, const glm::dvec3& half, double power, int steps) {
    Shell shell;
    std::map<std::array<int, 3>, std::uint32_t> known;
    // Grid points of the cube's faces, evenly spread by angle; shared along its edges.
    const auto vertex = [&](const std::array<int, 3>& cell) {
        const auto [found, added] = known.try_emplace(cell, size(shell));
        if (!added) return found->second;
        glm::dvec3 p{0.0};
        for (int axis = 0; axis < 3; ++axis)
            p[axis] = std::tan(glm::quarter_pi<double>() *
                               (2.0 * cell[static_cast<std::size_t>(axis)] / steps - 1.0));
        const double norm = std::pow(std::pow(std::abs(p.x), power) + std::pow(std::abs(p.y), power) +
                                         std::pow(std::abs(p.z), power),
                                     1.0 / power);
        shell.positions.push_back(centre + half * p / norm);
        return found->second;
    };
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (int side : {0, steps})
            for (int i = 0; i < steps; ++i)
                for (int j = 0; j < steps; ++j) {
                    const auto at = [&](int di, int dj) {
                        std::array<int, 3> cell{};
                        cell[axis] = side;
                        cell[(axis + 1) % 3] = side ? i + di : j + dj;
                        cell[(axis + 2) % 3] = side ? j + dj : i + di;
                        return vertex(cell);
                    };
                    const std::uint32_t a = at(0, 0), b = at(1, 0), c = at(1, 1), d = at(0, 1);
                    shell.indices.insert(shell.indices.end(), {a, b, c, a, c, d});
                }
    return shell;
}

Shell sheet(const Sheet& s) {
    const auto row = static_cast<std::uint32_t>(s.nv + 1);
    const auto middle = [&](double u, double v) { return s.middle(u, v); };
    Shell shell;
    std::vector<std::uint32_t> other; // the far side's index of each grid point
    std::vector<glm::dvec3> far;
    const std::uint32_t near = row * static_cast<std::uint32_t>(s.nu + 1);
    for (int i = 0; i <= s.nu; ++i)
        for (int j = 0; j <= s.nv; ++j) {
            const double u = double(i) / s.nu, v = double(j) / s.nv;
            const glm::dvec3 p = middle(u, v);
            shell.colours.push_back(s.colour ? s.colour(u, v) : glm::dvec3{0.8});
            const bool rim = i == 0 || j == 0 || i == s.nu || j == s.nv;
            other.push_back(rim ? size(shell) : near + static_cast<std::uint32_t>(far.size()));
            if (rim) {
                shell.positions.push_back(p);
                continue;
            }
            const double e = 1e-3;
            const glm::dvec3 normal = glm::normalize(
                glm::cross(middle(u + e, v) - middle(u - e, v), middle(u, v + e) - middle(u, v - e)));
            shell.positions.push_back(p + s.half(u, v) * normal);
            far.push_back(p - s.half(u, v) * normal);
        }
    for (std::uint32_t i = 0; i < near; ++i)
        if (other[i] != i) shell.colours.push_back(glm::dvec3{shell.colours[i]});
    shell.positions.insert(shell.positions.end(), far.begin(), far.end());
    for (std::uint32_t i = 0; i + row < near; i += row)
        for (std::uint32_t j = 0; j + 1 < row; ++j) {
            std::array<std::uint32_t, 4> cell{i + j, i + j + row, i + j + row + 1, i + j + 1};
            // At two of the corners the other diagonal, or a triangle would have no thickness behind it.
            if ((i == 0) == (j != 0)) std::rotate(cell.begin(), cell.begin() + 1, cell.end());
            for (std::size_t corner : {0, 1, 2, 0, 2, 3})
                shell.indices.push_back(cell[corner]);
            for (std::size_t corner : {0, 2, 1, 0, 3, 2})
                shell.indices.push_back(other[cell[corner]]);
        }
    return shell;
}

} // namespace limpid::models
