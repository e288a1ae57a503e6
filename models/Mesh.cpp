#include "Mesh.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

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

double angleBetween(const glm::dvec3& a, const glm::dvec3& b) {
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

/// Gives each distinct vertex one index, in order of first use.
class Welder {
  public:
    explicit Welder(Mesh& mesh) : _mesh{mesh} {}

    std::uint32_t indexOf(const glm::dvec3& p, const glm::dvec3& n) {
        const auto [found, added] = _known.try_emplace({p.x, p.y, p.z, n.x, n.y, n.z}, next());
        if (added) {
            _mesh.positions.push_back(p);
            _mesh.normals.push_back(n);
        }
        return found->second;
    }

  private:
    std::uint32_t next() const { return static_cast<std::uint32_t>(_mesh.positions.size()); }

    Mesh& _mesh;
    std::map<std::array<double, 6>, std::uint32_t> _known;
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

    Mesh result;
    Welder welder{result};
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        std::array<std::uint32_t, 3> triangle{};
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const std::uint32_t index = mesh.indices[i + corner];
            triangle[corner] = welder.indexOf(rounded((mesh.positions[index] - origin) * scale, step),
                                              rounded(mesh.normals[index], step));
        }
        if (hasArea(result, triangle))
            result.indices.insert(result.indices.end(), triangle.begin(), triangle.end());
    }
    return result;
}

} // namespace limpid::models
