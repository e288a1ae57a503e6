#include "io/gltf/Triangles.h"

#include <array>
#include <optional>

#include <fmt/format.h>

#include "io/gltf/Accessor.h"

namespace limpid::io {

namespace {

std::size_t triangleCount(int mode, std::size_t count) {
    if (mode == TINYGLTF_MODE_TRIANGLES) return count / 3;
    const bool joined = mode == TINYGLTF_MODE_TRIANGLE_STRIP || mode == TINYGLTF_MODE_TRIANGLE_FAN;
    return joined && count >= 3 ? count - 2 : 0;
}

/// Where the corners of triangle `i` stand in the primitive's vertices: glTF 2.0, 3.7.2.1.
std::array<std::size_t, 3> cornersOf(int mode, std::size_t i) {
    if (mode == TINYGLTF_MODE_TRIANGLE_STRIP) return {i, i + 1 + i % 2, i + 2 - i % 2};
    if (mode == TINYGLTF_MODE_TRIANGLE_FAN) return {i + 1, i + 2, 0};
    return {3 * i, 3 * i + 1, 3 * i + 2};
}

} // namespace

std::vector<std::uint32_t> triangleCorners(const GltfFile& file, const std::string& place,
                                           const tinygltf::Primitive& primitive, std::size_t vertexCount,
                                           std::size_t limit) {
    const AccessorKind kind{{TINYGLTF_TYPE_SCALAR},
                            {TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE, TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT,
                             TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT},
                            "scalars of 8, 16 or 32 bits without sign"};
    std::optional<AccessorView> indices;
    if (primitive.indices != -1) indices.emplace(file, place + ".indices", primitive.indices, kind);
    const std::size_t triangles = triangleCount(primitive.mode, indices ? indices->count() : vertexCount);
    if (triangles > limit / 3)
        file.fail(place, fmt::format("at most {} triangles", limit / 3), fmt::format("{}", triangles));
    std::vector<std::uint32_t> corners;
    corners.reserve(3 * triangles);
    for (std::size_t i = 0; i < triangles; ++i) {
        std::array<std::uint32_t, 3> triangle{};
        for (std::size_t c = 0; c < 3; ++c) {
            const std::size_t at = cornersOf(primitive.mode, i)[c];
            triangle[c] = indices ? indices->index(at) : static_cast<std::uint32_t>(at);
            if (triangle[c] >= vertexCount)
                file.fail(fmt::format("{}.indices[{}]", place, at),
                          fmt::format("an index below {}", vertexCount), fmt::format("{}", triangle[c]));
        }
        if (triangle[0] != triangle[1] && triangle[1] != triangle[2] && triangle[2] != triangle[0])
            corners.insert(corners.end(), triangle.begin(), triangle.end());
    }
    return corners;
}

} // namespace limpid::io
