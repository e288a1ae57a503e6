#include "Models.h"
#include "TeapotPatches.h"

#include <glm/geometric.hpp>

namespace limpid::models {

namespace {

/// Control points by row (parameter u) and column (parameter v).
using Patch = std::array<std::array<glm::dvec3, 4>, 4>;
using Weights = std::array<double, 4>;

Patch quarter(const std::array<QuarterRow, 4>& rows) {
    Patch patch;
    for (std::size_t i = 0; i < 4; ++i) {
        const auto& [r, k, z] = rows[i];
        patch[i] = {{{r, 0.0, z}, {r, -k, z}, {k, -r, z}, {0.0, -r, z}}};
    }
    return patch;
}

Patch half(const std::array<std::array<ControlPoint, 4>, 4>& rows) {
    Patch patch;
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j)
            patch[i][j] = {rows[i][j].x, rows[i][j].y, rows[i][j].z};
    return patch;
}

Patch turnedQuarter(Patch patch) {
    for (auto& row : patch)
        for (glm::dvec3& p : row)
            p = {p.y, -p.x, p.z};
    return patch;
}

// Columns change order with the side, so that the surface still faces outward.
Patch mirrored(const Patch& patch) {
    Patch result;
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j)
            result[i][j] = patch[i][3 - j] * glm::dvec3{1.0, -1.0, 1.0};
    return result;
}

std::vector<Patch> allPatches() {
    std::vector<Patch> patches;
    for (const auto& rows : quarterPatches) {
        Patch patch = quarter(rows);
        for (int turn = 0; turn < 4; ++turn, patch = turnedQuarter(patch))
            patches.push_back(patch);
    }
    for (const auto& rows : halfPatches) {
        patches.push_back(half(rows));
        patches.push_back(mirrored(patches.back()));
    }
    return patches;
}

Weights bernstein(double t) {
    const double s = 1.0 - t;
    return {s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t};
}

Weights bernsteinDerivative(double t) {
    const double s = 1.0 - t;
    return {-3.0 * s * s, 3.0 * s * s - 6.0 * s * t, 6.0 * s * t - 3.0 * t * t, 3.0 * t * t};
}

glm::dvec3 weighted(const Patch& patch, const Weights& u, const Weights& v) {
    glm::dvec3 sum{0.0};
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j)
            sum += u[i] * v[j] * patch[i][j];
    return sum;
}

// Outward: the patches' rows go down the pot and their columns clockwise seen from above.
glm::dvec3 normalAt(const Patch& patch, double u, double v) {
    const glm::dvec3 alongU = weighted(patch, bernsteinDerivative(u), bernstein(v));
    glm::dvec3 alongV = weighted(patch, bernstein(u), bernsteinDerivative(v));
    if (glm::length(alongV) < 1e-9) {
        // A pole, where a whole row is one point: the direction that ∂P/∂v has just beside it.
        const glm::dvec3 change = weighted(patch, bernsteinDerivative(u), bernsteinDerivative(v));
        alongV = u < 0.5 ? change : -change;
    }
    return glm::normalize(glm::cross(alongV, alongU));
}

// Newell's z is up, ours is y; a turn, so that nothing is mirrored.
glm::dvec3 upright(const glm::dvec3& v) {
    return {v.x, v.z, -v.y};
}

void appendPatch(Mesh& mesh, const Patch& patch, int steps) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    const auto row = static_cast<std::uint32_t>(steps + 1);
    for (int i = 0; i <= steps; ++i)
        for (int j = 0; j <= steps; ++j) {
            const double u = double(i) / steps;
            const double v = double(j) / steps;
            mesh.positions.push_back(upright(weighted(patch, bernstein(u), bernstein(v))));
            mesh.normals.push_back(upright(normalAt(patch, u, v)));
        }
    for (std::uint32_t i = 0; i + 1 < row; ++i)
        for (std::uint32_t j = 0; j + 1 < row; ++j)
            for (std::uint32_t corner : {0u, 1u, row + 1, 0u, row + 1, row})
                mesh.indices.push_back(first + i * row + j + corner);
}

} // namespace

Mesh teapot(int steps) {
    Mesh mesh;
    for (const Patch& patch : allPatches())
        appendPatch(mesh, patch, steps);
    return mesh;
}

} // namespace limpid::models
