#include "Models.h"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include <cmath>
#include <set>
#include <tuple>

namespace limpid::models {

namespace {

using Cell = std::tuple<int, int, int>;

glm::dvec3 unit(int axis) {
    glm::dvec3 v{0.0};
    v[axis] = 1.0;
    return v;
}

// The face of the cube around `centre` (edge 1) that looks along `axis`, forward or backward.
void appendCubeFace(Mesh& mesh, const glm::dvec3& centre, int axis, double sign) {
    const glm::dvec3 out = 0.5 * sign * unit(axis);
    const glm::dvec3 u = 0.5 * unit((axis + 1) % 3);
    const glm::dvec3 v = 0.5 * sign * unit((axis + 2) % 3);
    const glm::dvec3 middle = centre + out;
    appendQuad(mesh, middle - u - v, middle + u - v, middle + u + v, middle - u + v);
}

// The surface of the union of unit cubes: the faces that have no neighbour.
Mesh cubes(const std::set<Cell>& cells) {
    Mesh mesh;
    for (const auto& [x, y, z] : cells)
        for (int axis = 0; axis < 3; ++axis)
            for (int sign : {-1, 1}) {
                const glm::dvec3 centre{x, y, z};
                const glm::dvec3 beside = centre + double(sign) * unit(axis);
                if (!cells.contains({int(beside.x), int(beside.y), int(beside.z)}))
                    appendCubeFace(mesh, centre, axis, sign);
            }
    return mesh;
}

// A whole number of steps is reduced to one turn and the poles are set by hand, so that the seam and the
// poles are one point each whatever the sine's last bit says.
glm::dvec3 onSphere(int slice, int slices, int stack, int stacks) {
    if (stack == 0) return {0.0, 1.0, 0.0};
    if (stack == stacks) return {0.0, -1.0, 0.0};
    const double around = glm::two_pi<double>() * (slice % slices) / slices;
    const double down = glm::pi<double>() * stack / stacks;
    return {std::sin(down) * std::cos(around), std::cos(down), -std::sin(down) * std::sin(around)};
}

} // namespace

Mesh sphere(int slices, int stacks) {
    Mesh mesh;
    for (int stack = 0; stack < stacks; ++stack)
        for (int slice = 0; slice < slices; ++slice) {
            const auto first = static_cast<std::uint32_t>(mesh.positions.size());
            for (const auto& [ds, dt] : {std::pair{0, 0}, {0, 1}, {1, 1}, {1, 0}})
                mesh.positions.push_back(onSphere(slice + ds, slices, stack + dt, stacks));
            for (std::uint32_t corner : {0u, 1u, 2u, 0u, 2u, 3u})
                mesh.indices.push_back(first + corner);
        }
    mesh.normals = mesh.positions; // a unit sphere is its own normals
    return mesh;
}

Mesh box() {
    return cubes({{0, 0, 0}});
}

Mesh cross() {
    return cubes({{0, 0, 0},
                  {1, 0, 0},
                  {-1, 0, 0},
                  {0, 1, 0},
                  {0, -1, 0},
                  {0, 0, 1},
                  {0, 0, -1},
                  {2, 0, 0},
                  {-2, 0, 0}});
}

} // namespace limpid::models
