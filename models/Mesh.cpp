#include "Mesh.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

namespace limpid::models {

namespace {

struct Bounds {
    glm::dvec3 min{std::numeric_limits<double>::max()};
    glm::dvec3 max{std::numeric_limits<double>::lowest()};
};

Bounds boundsOf(const std::vector<glm::dvec3>& positions) {
    Bounds bounds;
    for (const glm::dvec3& position : positions) {
        bounds.min = glm::min(bounds.min, position);
        bounds.max = glm::max(bounds.max, position);
    }
    return bounds;
}

// Adding zero turns −0 into 0, which compares equal but has other bytes.
glm::dvec3 rounded(const glm::dvec3& v, double step) {
    return glm::round(v / step) * step + 0.0;
}

bool hasArea(const Mesh& mesh, const std::array<std::uint32_t, 3>& t) {
    const glm::dvec3 a = mesh.positions[t[0]];
    return glm::length(glm::cross(mesh.positions[t[1]] - a, mesh.positions[t[2]] - a)) > 1e-10;
}

constexpr double colourStep = 1.0 / 65535.0; // what 16 bits hold

double angleBetween(const glm::dvec3& a, const glm::dvec3& b) {
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

/// A triangle's normal and its angle at one of its corners; both zero where the triangle has no area.
struct Corner {
    glm::dvec3 normal{0.0};
    double angle = 0.0;
};

std::vector<Corner> cornersOf(const Shell& shell) {
    std::vector<Corner> corners(shell.indices.size());
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const std::size_t first = i - i % 3;
        const glm::dvec3 here = shell.positions[shell.indices[i]];
        const glm::dvec3 a = shell.positions[shell.indices[first + (i + 1) % 3]] - here;
        const glm::dvec3 b = shell.positions[shell.indices[first + (i + 2) % 3]] - here;
        const glm::dvec3 across = glm::cross(a, b);
        if (glm::length(across) > 1e-14) corners[i] = {glm::normalize(across), angleBetween(a, b)};
    }
    return corners;
}

/// Gives each distinct vertex one index, in order of first use.
class Welder {
  public:
    explicit Welder(Mesh& mesh) : _mesh{mesh} {}

    /// `c` is null where the mesh has no colours.
    std::uint32_t indexOf(const glm::dvec3& p, const glm::dvec3& n, const glm::dvec3* c) {
        const glm::dvec3 key = c ? *c : glm::dvec3{0.0};
        const auto [found, added] =
            _known.try_emplace({p.x, p.y, p.z, n.x, n.y, n.z, key.x, key.y, key.z}, next());
        if (added) {
            _mesh.positions.push_back(p);
            _mesh.normals.push_back(n);
            if (c) _mesh.colours.push_back(*c);
        }
        return found->second;
    }

  private:
    std::uint32_t next() const { return static_cast<std::uint32_t>(_mesh.positions.size()); }

    Mesh& _mesh;
    std::map<std::array<double, 9>, std::uint32_t> _known;
};

} // namespace

void appendSmooth(Mesh& mesh, const Shell& shell) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    std::vector<glm::dvec3> normals(shell.positions.size(), glm::dvec3{0.0});
    for (std::size_t i = 0; i < shell.indices.size(); i += 3)
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const std::uint32_t here = shell.indices[i + corner];
            const glm::dvec3 a = shell.positions[shell.indices[i + (corner + 1) % 3]] - shell.positions[here];
            const glm::dvec3 b = shell.positions[shell.indices[i + (corner + 2) % 3]] - shell.positions[here];
            normals[here] += angleBetween(a, b) * glm::normalize(glm::cross(a, b));
        }
    mesh.positions.insert(mesh.positions.end(), shell.positions.begin(), shell.positions.end());
    for (const glm::dvec3& normal : normals)
        mesh.normals.push_back(glm::normalize(normal));
    for (std::uint32_t index : shell.indices)
        mesh.indices.push_back(first + index);
}

void appendCreased(Mesh& mesh, const Shell& shell, double crease) {
    const double least = std::cos(glm::radians(crease));
    const std::vector<Corner> corners = cornersOf(shell);
    std::vector<std::vector<std::size_t>> around(shell.positions.size());
    for (std::size_t i = 0; i < corners.size(); ++i)
        around[shell.indices[i]].push_back(i);

    for (std::size_t i = 0; i < corners.size(); ++i) {
        const std::uint32_t vertex = shell.indices[i];
        glm::dvec3 sum{0.0};
        for (std::size_t other : around[vertex])
            if (other == i || glm::dot(corners[other].normal, corners[i].normal) > least)
                sum += corners[other].angle * corners[other].normal;
        mesh.indices.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
        mesh.positions.push_back(shell.positions[vertex]);
        mesh.normals.push_back(glm::length(sum) > 0.0 ? glm::normalize(sum) : glm::dvec3{0.0, 1.0, 0.0});
        if (!shell.colours.empty()) mesh.colours.push_back(shell.colours[vertex]);
    }
}

void appendQuad(Mesh& mesh, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
                const glm::dvec3& d) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), {a, b, c, d});
    mesh.normals.insert(mesh.normals.end(), 4, glm::normalize(glm::cross(b - a, c - a)));
    for (std::uint32_t corner : {0u, 1u, 2u, 0u, 2u, 3u})
        mesh.indices.push_back(first + corner);
}

Mesh finished(const Mesh& mesh, double step) {
    const Bounds bounds = boundsOf(mesh.positions);
    const glm::dvec3 extent = bounds.max - bounds.min;
    const double scale = 1.0 / std::max({extent.x, extent.y, extent.z});
    const glm::dvec3 middle = 0.5 * (bounds.min + bounds.max);
    const glm::dvec3 origin{middle.x, bounds.min.y, middle.z};

    std::vector<glm::dvec3> colours;
    for (const glm::dvec3& colour : mesh.colours)
        colours.push_back(rounded(glm::clamp(colour, 0.0, 1.0), colourStep));

    Mesh result;
    Welder welder{result};
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        std::array<std::uint32_t, 3> triangle{};
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const std::uint32_t index = mesh.indices[i + corner];
            triangle[corner] = welder.indexOf(rounded((mesh.positions[index] - origin) * scale, step),
                                              rounded(mesh.normals[index], step),
                                              colours.empty() ? nullptr : &colours[index]);
        }
        if (hasArea(result, triangle))
            result.indices.insert(result.indices.end(), triangle.begin(), triangle.end());
    }
    return result;
}

} // namespace limpid::models
