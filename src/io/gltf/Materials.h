#pragma once
#include <glm/glm.hpp>

#include "io/gltf/File.h"
#include "scene/Mesh.h"

namespace limpid::io {

/// Fills `mesh.materials` with the file's materials in their order, after them the format's default (white)
/// if a part uses it or there are no others, and `mesh.images` with the textures of those that parts use. An
/// image that is missing or cannot be decoded costs a notice, and its materials do without it.
/// Throws InputError for an index or factor that breaks the format.
void addMaterials(const GltfFile& file, Mesh& mesh);

/// The material index that `addMaterials` will give to a primitive. Throws InputError.
int materialIndex(const GltfFile& file, const std::string& place, const tinygltf::Primitive& primitive);

/// How a texture is put onto a surface.
struct TextureMapping {
    int texCoord = 0;          ///< the set of texture coordinates
    glm::dmat3 transform{1.0}; ///< of homogeneous (u, v, 1), from KHR_texture_transform

    bool operator==(const TextureMapping&) const = default;
};

/// Of a material's base colour texture, which transmission and emission share, and its normal map; where it
/// has one of them alone, both as that one.
struct TextureMappings {
    TextureMapping color, normal;
};

/// `material`: a primitive's, not yet checked. Throws InputError.
TextureMappings textureMappings(const GltfFile& file, int material);

} // namespace limpid::io
