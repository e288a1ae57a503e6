#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include <glm/glm.hpp>

namespace limpid {

/// An 8-bit picture: `rgba` holds width · height · 4 bytes, rows from the top, colours sRGB, alpha straight.
struct Image {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgba;
};

/// How a surface looks. Flux does not depend on it; the picture does.
struct Material {
    glm::vec4 baseColor{0.8f, 0.8f, 0.8f, 1.0f}; ///< linear RGB and alpha, multiplied with the texture
    int baseColorImage = -1;                     ///< index into Mesh::images, -1 for none
};

/// A run of triangles that share a material.
struct MeshPart {
    std::uint32_t firstIndex = 0;
    std::uint32_t indexCount = 0; ///< a multiple of 3
    int material = 0;             ///< index into Mesh::materials
};

/// Triangles in the receiver's own space, metres, Y up, right-handed.
/// `normals` (unit, shading) and `uvs` have the length of `positions`.
/// Loaders guarantee: every index is in range, every number finite, at least one material.
struct Mesh {
    std::vector<glm::dvec3> positions;
    std::vector<glm::vec3> normals;
    std::vector<glm::vec2> uvs;
    std::vector<std::uint32_t> indices;
    std::vector<MeshPart> parts;
    std::vector<Material> materials;
    std::vector<Image> images;

    std::size_t triangleCount() const { return indices.size() / 3; }
};

} // namespace limpid
