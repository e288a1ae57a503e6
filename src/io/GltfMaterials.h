#pragma once
#include <glm/glm.hpp>

#include "io/GltfFile.h"
#include "scene/Mesh.h"

namespace limpid::io {

/// Fills `mesh.materials` with the file's materials in their order, after them the format's default (white)
/// if a part uses it or there are no others, and `mesh.images` with the base colour textures and normal maps
/// of those that parts use. An image that is missing or cannot be decoded costs one line on stderr, and its
/// materials do without it. Throws InputError for an index or factor that breaks the format.
void addMaterials(const GltfFile& file, Mesh& mesh);

/// The material index that `addMaterials` will give to a primitive. Throws InputError.
int materialIndex(const GltfFile& file, const std::string& place, const tinygltf::Primitive& primitive);

/// How a material's base colour texture is put onto a surface; its normal map if it has only that.
struct TextureMapping {
    int texCoord = 0;          ///< the set of texture coordinates
    glm::dmat3 transform{1.0}; ///< of homogeneous (u, v, 1), from KHR_texture_transform
};

/// `material`: a primitive's, not yet checked. Throws InputError.
TextureMapping textureMapping(const GltfFile& file, int material);

} // namespace limpid::io
