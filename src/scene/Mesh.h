#pragma once
#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include <glm/glm.hpp>

namespace limpid {

/// An 8-bit picture: `rgba` holds width · height · 4 bytes, rows from the top, alpha straight.
struct Image {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgba;
    bool srgb = true; ///< RGB are colours, sRGB encoded; otherwise they are data, such as a normal map
};

/// What a texture gives outside of [0, 1].
enum class Wrap { Repeat, Mirror, Clamp };

/// What alpha means: nothing; a hole below the material's cutoff; the share of the surface's own colour.
enum class AlphaMode { Opaque, Mask, Blend };

/// How a surface looks, and how much light goes through it.
struct Material {
    glm::vec4 baseColor{0.8f, 0.8f, 0.8f, 1.0f}; ///< linear RGB and alpha, times texture and vertex colour
    int baseColorImage = -1;                     ///< index into Mesh::images, -1 for none
    Wrap baseColorWrapS = Wrap::Repeat;          ///< along u
    Wrap baseColorWrapT = Wrap::Repeat;          ///< along v
    bool baseColorNearest = false;               ///< magnified without interpolation
    AlphaMode alphaMode = AlphaMode::Opaque;
    float alphaCutoff = 0.5f; ///< AlphaMode::Mask: alpha below it is a hole
    bool doubleSided = false; ///< as the file says; every face's back takes light and shows, all the same
    int normalImage = -1;     ///< tangent-space normal map on the mesh's normal uvs, -1 for none
    float normalScale = 1;    ///< times x and y of the map's normals
    Wrap normalWrapS = Wrap::Repeat;
    Wrap normalWrapT = Wrap::Repeat;
    float transmission = 0;     ///< share of the light that enters the surface and goes on behind it, [0, 1]
    int transmissionImage = -1; ///< its red channel times `transmission`, on the mesh's uvs; -1 for none
    Wrap transmissionWrapS = Wrap::Repeat;
    Wrap transmissionWrapT = Wrap::Repeat;
    glm::vec3 emission{0};  ///< radiance of its own, W/(m² sr), linear RGB, >= 0; lights nothing else
    int emissionImage = -1; ///< colours times `emission`, on the mesh's uvs; -1 for none
    Wrap emissionWrapS = Wrap::Repeat;
    Wrap emissionWrapT = Wrap::Repeat;
    std::string name{}; ///< in the file; may be empty
};

/// Whether light may pass a material's faces: through cut-outs' holes, or all of what is blended or
/// transmissive.
inline bool isTranslucent(const Material& material) {
    return material.alphaMode != AlphaMode::Opaque || material.transmission > 0;
}

/// A material of which something shows through all faces, not through holes alone.
inline bool isBlended(const Material& material) {
    return material.alphaMode == AlphaMode::Blend || material.transmission > 0;
}

/// Alpha from which something blended hides all that is behind it: the last of 256 steps. The shader
/// view/receiver.frag has it too.
inline constexpr float solidAlpha = 254.5f / 255;

/// Share of the light, by channel, that goes on behind a place of a face; the face takes the rest. It goes on
/// unbent: sheets are thin and have water on either side, and a closed body is its two faces. `color`: base
/// colour times texture and vertex colour, linear RGB and alpha, [0, 1]; `transmission`: the material's times
/// its texture, [0, 1].
inline glm::vec3 transmittance(const Material& material, const glm::vec4& color, float transmission) {
    if (material.alphaMode == AlphaMode::Mask && color.a < material.alphaCutoff) return glm::vec3(1);
    const glm::vec3 through = transmission * glm::vec3(color);
    return material.alphaMode == AlphaMode::Blend ? 1 - color.a + color.a * through : through;
}

/// A run of triangles that share a material.
struct MeshPart {
    std::uint32_t firstIndex = 0;
    std::uint32_t indexCount = 0; ///< a multiple of 3
    int material = 0;             ///< index into Mesh::materials
};

/// A node of the file that a mesh was read from.
struct MeshNode {
    std::string name, meshName;    ///< of the node, and of the mesh that it shows; may be empty
    std::uint32_t firstVertex = 0; ///< its vertices, which triangles of no other node use
    std::uint32_t vertexCount = 0;
};

/// Triangles in the receiver's own space, metres, Y up, right-handed.
/// `normals` (unit, shading) and `uvs` have the length of `positions`; `normalUvs` and `colors` too, or they
/// are empty.
/// Loaders guarantee: every index is in range, every number finite, at least one material.
struct Mesh {
    std::vector<glm::dvec3> positions;
    std::vector<glm::vec3> normals;
    std::vector<glm::vec2> uvs;
    std::vector<glm::vec2> normalUvs; ///< where normal maps lie; empty if as the base colour does
    std::vector<glm::vec4> colors;    ///< linear RGB and alpha, times the material's; empty if all are white
    std::vector<std::uint32_t> indices;
    std::vector<MeshPart> parts;
    std::vector<Material> materials;
    std::vector<Image> images;
    std::vector<MeshNode> nodes;      ///< in the order of their vertices; empty for shapes
    std::vector<std::string> notices; ///< file, place, and why it is not used: one line each

    std::size_t triangleCount() const { return indices.size() / 3; }
};

/// A mesh of which some is blended and the rest is not. A map of it shows the rest: one surface has a texel,
/// and a sheet that had it would take it from what the light meets behind the sheet.
inline bool isPartlyBlended(const Mesh& mesh) {
    const auto blended = [&](const MeshPart& p) {
        return isBlended(mesh.materials[std::size_t(p.material)]);
    };
    return std::any_of(mesh.parts.begin(), mesh.parts.end(), blended) &&
           !std::all_of(mesh.parts.begin(), mesh.parts.end(), blended);
}

/// Alpha below which a place of the material is a hole, 0: none is; `ofBlended` of what is blended.
inline float holeAlpha(const Material& material, float ofBlended) {
    switch (material.alphaMode) {
    case AlphaMode::Opaque:
        return 0;
    case AlphaMode::Mask:
        return material.alphaCutoff;
    case AlphaMode::Blend:
        return ofBlended;
    }
    return 0;
}

/// Alpha from which a map shows a place of the material; above 1 where it never does. `partly`: of a mesh
/// that is partly blended.
inline float shownAlpha(const Material& material, bool partly) {
    if (partly && material.transmission > 0) return 2;
    // The soft rim of a leaf on a texture counts from its middle.
    return holeAlpha(material, partly ? solidAlpha : std::max(0.5f * material.baseColor.a, 0.5f / 255));
}

} // namespace limpid
