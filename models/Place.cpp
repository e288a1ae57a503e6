#include "Place.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>

namespace limpid::models {

namespace {

double linear(unsigned byte) {
    const double c = byte / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

// In [0, 1], from whole numbers alone.
double hashed(int x, int y, int z, unsigned salt) {
    unsigned h = salt * 0x9E3779B1u;
    for (int v : {x, y, z}) {
        h ^= static_cast<unsigned>(v) * 0x85EBCA77u;
        h = (h ^ (h >> 15)) * 0xC2B2AE3Du;
        h ^= h >> 13;
    }
    return (h & 0xFFFFFFu) / double(0xFFFFFF);
}

} // namespace

glm::dvec3 rgb(unsigned hex) {
    return {linear(hex >> 16 & 255u), linear(hex >> 8 & 255u), linear(hex & 255u)};
}

Shell painted(Shell shell, const Paint& paint) {
    shell.colours.clear();
    for (const glm::dvec3& p : shell.positions)
        shell.colours.push_back(paint(p));
    return shell;
}

Shell painted(Shell shell, unsigned hex) {
    return painted(std::move(shell), [colour = rgb(hex)](const glm::dvec3&) { return colour; });
}

Shell shaped(Shell shell, const std::function<glm::dvec3(const glm::dvec3&)>& f) {
    for (glm::dvec3& p : shell.positions)
        p = f(p);
    return shell;
}

Shell moved(Shell shell, const glm::dvec3& offset) {
    return shaped(std::move(shell), [&](const glm::dvec3& p) { return p + offset; });
}

Shell scaled(Shell shell, const glm::dvec3& factors) {
    return shaped(std::move(shell), [&](const glm::dvec3& p) { return p * factors; });
}

Shell turned(Shell shell, int axis, double degrees) {
    const double c = std::cos(glm::radians(degrees)), s = std::sin(glm::radians(degrees));
    const int a = (axis + 1) % 3, b = (axis + 2) % 3;
    return shaped(std::move(shell), [&](glm::dvec3 p) {
        const double pa = p[a], pb = p[b];
        p[a] = c * pa - s * pb;
        p[b] = s * pa + c * pb;
        return p;
    });
}

Shell swollen(Shell shell, const std::function<double(const glm::dvec3&)>& amount) {
    std::vector<glm::dvec3> normals(shell.positions.size(), glm::dvec3{0.0});
    for (std::size_t i = 0; i < shell.indices.size(); i += 3) {
        const glm::dvec3 a = shell.positions[shell.indices[i]];
        const glm::dvec3 area =
            glm::cross(shell.positions[shell.indices[i + 1]] - a, shell.positions[shell.indices[i + 2]] - a);
        for (std::size_t corner = 0; corner < 3; ++corner)
            normals[shell.indices[i + corner]] += area;
    }
    for (std::size_t i = 0; i < normals.size(); ++i)
        if (glm::length(normals[i]) > 0.0)
            shell.positions[i] += amount(shell.positions[i]) * glm::normalize(normals[i]);
    return shell;
}

double ramp(double from, double to, double x) {
    return glm::smoothstep(0.0, 1.0, (x - from) / (to - from));
}

double bump(double centre, double width, double x) {
    return 1.0 - ramp(0.0, width, std::abs(x - centre));
}

double noise(const glm::dvec3& p, double size) {
    const glm::dvec3 q = p / size, cell = glm::floor(q);
    const glm::dvec3 w = glm::smoothstep(glm::dvec3{0.0}, glm::dvec3{1.0}, q - cell);
    double sum = 0.0;
    for (int i = 0; i < 8; ++i) {
        const int dx = i & 1, dy = i >> 1 & 1, dz = i >> 2;
        sum += (dx ? w.x : 1.0 - w.x) * (dy ? w.y : 1.0 - w.y) * (dz ? w.z : 1.0 - w.z) *
               hashed(int(cell.x) + dx, int(cell.y) + dy, int(cell.z) + dz, 1);
    }
    return sum;
}

double scatter(const glm::dvec3& p, double size) {
    const glm::dvec3 q = p / size, cell = glm::floor(q);
    double nearest = 2.0;
    for (int i = 0; i < 27; ++i) {
        const glm::dvec3 c = cell + glm::dvec3{i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1};
        const int x = int(c.x), y = int(c.y), z = int(c.z);
        const glm::dvec3 jitter{hashed(x, y, z, 2), hashed(x, y, z, 3), hashed(x, y, z, 4)};
        nearest = std::min(nearest, glm::distance(q, c + 0.2 + 0.6 * jitter));
    }
    return nearest;
}

double flankScatter(const glm::dvec3& p, double size) {
    const glm::dvec2 q = glm::dvec2{p} / size, cell = glm::floor(q);
    double nearest = 2.0;
    for (int i = 0; i < 9; ++i) {
        const glm::dvec2 c = cell + glm::dvec2{i % 3 - 1, i / 3 - 1};
        const int x = int(c.x), y = int(c.y), side = p.z < 0.0 ? 0 : 1;
        nearest = std::min(
            nearest,
            glm::distance(q, c + 0.15 + 0.7 * glm::dvec2{hashed(x, y, side, 5), hashed(x, y, side, 6)}));
    }
    return nearest;
}

} // namespace limpid::models
