#include "scene/Places.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <tuple>

namespace limpid {

namespace {

/// Marks, in the part's triangles, those that repeat an earlier one.
std::vector<bool> repeated(const Mesh& mesh, const MeshPart& part, const std::vector<std::uint32_t>& places) {
    struct Triangle {
        std::array<std::uint32_t, 3> corners;
        std::uint32_t number;
        bool operator<(const Triangle& other) const {
            return std::tie(corners, number) < std::tie(other.corners, other.number);
        }
    };
    std::vector<Triangle> triangles(part.indexCount / 3);
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
        Triangle& triangle = triangles[t];
        triangle.number = t;
        for (std::uint32_t k = 0; k < 3; ++k)
            triangle.corners[k] = places[mesh.indices[part.firstIndex + 3 * t + k]];
        std::sort(triangle.corners.begin(), triangle.corners.end());
    }
    std::sort(triangles.begin(), triangles.end());
    std::vector<bool> marks(triangles.size(), false);
    for (std::size_t i = 1; i < triangles.size(); ++i)
        marks[triangles[i].number] = triangles[i].corners == triangles[i - 1].corners;
    return marks;
}

} // namespace

std::vector<std::uint32_t> placesOf(const std::vector<glm::dvec3>& positions) {
    std::vector<std::uint32_t> order(positions.size()), places(positions.size());
    std::iota(order.begin(), order.end(), 0u);
    const auto key = [&](std::uint32_t i) {
        return std::tuple(positions[i].x, positions[i].y, positions[i].z);
    };
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
    for (std::size_t i = 0; i < order.size(); ++i)
        places[order[i]] = i > 0 && key(order[i]) == key(order[i - 1]) ? places[order[i - 1]] : order[i];
    return places;
}

void dropRepeatedTriangles(Mesh& mesh) {
    const auto places = placesOf(mesh.positions);
    std::vector<std::uint32_t> kept;
    kept.reserve(mesh.indices.size());
    for (MeshPart& part : mesh.parts) {
        const auto marks = repeated(mesh, part, places);
        const auto first = static_cast<std::uint32_t>(kept.size());
        for (std::uint32_t t = 0; t < marks.size(); ++t)
            if (!marks[t])
                for (std::uint32_t k = 0; k < 3; ++k)
                    kept.push_back(mesh.indices[part.firstIndex + 3 * t + k]);
        part = {first, static_cast<std::uint32_t>(kept.size()) - first, part.material};
    }
    mesh.indices = std::move(kept);
}

} // namespace limpid
