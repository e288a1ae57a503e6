#include "io/GltfMaterials.h"

#include <algorithm>
#include <cmath>
#include <span>

#include <fmt/format.h>

#include "io/GltfCompressed.h"
#include "io/GltfImages.h"

namespace limpid::io {

namespace {

constexpr int samplerClamp = 33071;
constexpr int samplerMirror = 33648;
constexpr int samplerNearest = 9728;

/// A texture as a material refers to it: tinygltf has two types for that.
struct TextureUse {
    std::string place;
    int index;
    int texCoord;
    const tinygltf::ExtensionMap& extensions;
};

TextureUse baseColorUse(const GltfFile& file, std::size_t material) {
    const auto& info = file.model.materials[material].pbrMetallicRoughness.baseColorTexture;
    return {fmt::format("materials[{}].pbrMetallicRoughness.baseColorTexture", material), info.index,
            info.texCoord, info.extensions};
}

TextureUse normalUse(const GltfFile& file, std::size_t material) {
    const auto& info = file.model.materials[material].normalTexture;
    return {fmt::format("materials[{}].normalTexture", material), info.index, info.texCoord, info.extensions};
}

/// Null without a texture.
const tinygltf::Texture* textureOf(const GltfFile& file, const TextureUse& use) {
    if (use.index == -1) return nullptr;
    file.requireIndex(use.place + ".index", use.index, file.model.textures.size());
    return &file.model.textures[static_cast<std::size_t>(use.index)];
}

/// The file's image behind a texture, -1 for none.
int imageOf(const GltfFile& file, const TextureUse& use) {
    const tinygltf::Texture* texture = textureOf(file, use);
    if (!texture || texture->source == -1) return -1;
    file.requireIndex(fmt::format("textures[{}].source", use.index), texture->source,
                      file.model.images.size());
    return texture->source;
}

Wrap wrapOf(int mode) {
    return mode == samplerClamp ? Wrap::Clamp : mode == samplerMirror ? Wrap::Mirror : Wrap::Repeat;
}

/// Null without one.
const tinygltf::Sampler* samplerOf(const GltfFile& file, const TextureUse& use) {
    const tinygltf::Texture* texture = textureOf(file, use);
    if (!texture || texture->sampler == -1) return nullptr;
    file.requireIndex(fmt::format("textures[{}].sampler", use.index), texture->sampler,
                      file.model.samplers.size());
    return &file.model.samplers[static_cast<std::size_t>(texture->sampler)];
}

float finiteFactor(const GltfFile& file, const std::string& place, double factor) {
    if (!(std::abs(factor) <= 1e30)) file.fail(place, "finite numbers", fmt::format("{}", factor));
    return static_cast<float>(factor);
}

Material convert(const GltfFile& file, std::size_t index) {
    const tinygltf::Material& source = file.model.materials[index];
    const std::string place = fmt::format("materials[{}]", index);
    Material material;
    for (int c = 0; c < 4; ++c) {
        const double factor = source.pbrMetallicRoughness.baseColorFactor.at(static_cast<std::size_t>(c));
        const float value = finiteFactor(file, place + ".pbrMetallicRoughness.baseColorFactor", factor);
        material.baseColor[c] = std::clamp(value, 0.0f, 1.0f);
    }
    // A later version's modes count as the default, as glTF wants it of versions with the same first number.
    if (source.alphaMode == "MASK") material.alphaMode = AlphaMode::Mask;
    if (source.alphaMode == "BLEND") material.alphaMode = AlphaMode::Blend;
    material.alphaCutoff = std::max(finiteFactor(file, place + ".alphaCutoff", source.alphaCutoff), 0.0f);
    material.doubleSided = source.doubleSided;
    material.normalScale = finiteFactor(file, place + ".normalTexture.scale", source.normalTexture.scale);
    return material;
}

/// Member `key` of an extension's object: `values.size()` finite numbers, or nothing.
void readNumbers(const GltfFile& file, const std::string& place, const tinygltf::Value& object,
                 const char* key, std::span<double> values) {
    if (!object.Has(key)) return;
    const tinygltf::Value& source = object.Get(key);
    bool good =
        values.size() == 1 ? source.IsNumber() : source.IsArray() && source.ArrayLen() == values.size();
    for (std::size_t i = 0; good && i < values.size(); ++i) {
        const tinygltf::Value& number = values.size() == 1 ? source : source.Get(i);
        good = number.IsNumber() && std::isfinite(number.GetNumberAsDouble());
        if (good) values[i] = number.GetNumberAsDouble();
    }
    if (!good)
        file.fail(place + "." + key, fmt::format("{} finite number(s)", values.size()), "something else");
}

TextureMapping mappingOf(const GltfFile& file, const TextureUse& use) {
    TextureMapping mapping{use.texCoord};
    const tinygltf::Value* object = extensionObject(use.extensions, "KHR_texture_transform");
    if (!object) return mapping;
    const std::string place = use.place + ".KHR_texture_transform";
    double offset[2] = {0, 0}, scale[2] = {1, 1}, rotation[1] = {0}, texCoord[1] = {double(use.texCoord)};
    readNumbers(file, place, *object, "offset", offset);
    readNumbers(file, place, *object, "scale", scale);
    readNumbers(file, place, *object, "rotation", rotation);
    readNumbers(file, place, *object, "texCoord", texCoord);
    mapping.texCoord = static_cast<int>(std::clamp(texCoord[0], 0.0, 1e6));
    // The extension's matrices, multiplied: offset · rotation · scale. As v points down in a picture, this
    // turns the coordinates counter-clockwise in it.
    const double c = std::cos(rotation[0]), s = std::sin(rotation[0]);
    mapping.transform =
        glm::dmat3(c * scale[0], -s * scale[0], 0, s * scale[1], c * scale[1], 0, offset[0], offset[1], 1);
    return mapping;
}

/// The textures of a material that is in use.
void addTextures(const GltfFile& file, std::size_t index, ImageSet& images, Material& material) {
    const TextureUse color = baseColorUse(file, index), normal = normalUse(file, index);
    const int colorImage = imageOf(file, color), normalImage = imageOf(file, normal);
    if (colorImage >= 0) material.baseColorImage = images.add(colorImage, true);
    if (normalImage >= 0) material.normalImage = images.add(normalImage, false);
    if (const tinygltf::Sampler* sampler = samplerOf(file, color)) {
        material.baseColorWrapS = wrapOf(sampler->wrapS);
        material.baseColorWrapT = wrapOf(sampler->wrapT);
        material.baseColorNearest = sampler->magFilter == samplerNearest;
    }
    if (const tinygltf::Sampler* sampler = samplerOf(file, normal)) {
        material.normalWrapS = wrapOf(sampler->wrapS);
        material.normalWrapT = wrapOf(sampler->wrapT);
    }
}

} // namespace

TextureMappings textureMappings(const GltfFile& file, int material) {
    if (material < 0 || static_cast<std::size_t>(material) >= file.model.materials.size()) return {};
    const auto index = static_cast<std::size_t>(material);
    const TextureUse color = baseColorUse(file, index), normal = normalUse(file, index);
    TextureMappings mappings{mappingOf(file, color), mappingOf(file, normal)};
    if (imageOf(file, normal) < 0) mappings.normal = mappings.color;
    if (imageOf(file, color) < 0) mappings.color = mappings.normal;
    return mappings;
}

int materialIndex(const GltfFile& file, const std::string& place, const tinygltf::Primitive& primitive) {
    const std::size_t count = file.model.materials.size();
    if (primitive.material == -1) return static_cast<int>(count);
    file.requireIndex(place + ".material", primitive.material, count);
    return primitive.material;
}

void addMaterials(const GltfFile& file, Mesh& mesh) {
    const std::size_t count = file.model.materials.size();
    std::vector<bool> used(count + 1, false);
    for (const MeshPart& part : mesh.parts)
        used[static_cast<std::size_t>(part.material)] = true;
    ImageSet images(file, mesh.images);
    for (std::size_t i = 0; i < count; ++i) {
        mesh.materials.push_back(convert(file, i));
        if (used[i]) addTextures(file, i, images, mesh.materials.back());
    }
    if (used.back() || mesh.materials.empty()) mesh.materials.push_back(Material{glm::vec4(1.0f), -1});
}

} // namespace limpid::io
