#include "io/gltf/Materials.h"

#include <algorithm>
#include <cmath>
#include <span>

#include <fmt/format.h>

#include "io/gltf/Compressed.h"
#include "io/gltf/Extensions.h"
#include "io/gltf/Images.h"
#include "io/gltf/Notices.h"

namespace limpid::io {

namespace {

constexpr int samplerClamp = 33071;
constexpr int samplerMirror = 33648;
constexpr int samplerNearest = 9728;
constexpr char glossinessExtension[] = "KHR_materials_pbrSpecularGlossiness";
constexpr char transmissionExtension[] = "KHR_materials_transmission";

/// A texture as a material refers to it, in the core format or in an extension.
struct TextureUse {
    std::string place;
    int index = -1;
    int texCoord = 0;
    const tinygltf::Value* transform = nullptr; ///< KHR_texture_transform; null for none
};

template <typename Info>
TextureUse coreUse(std::string place, const Info& info) {
    return {std::move(place), info.index, info.texCoord,
            extensionObject(info.extensions, "KHR_texture_transform")};
}

/// Member `key` of an extension's object, the extension's name in `place`.
TextureUse extensionUse(const GltfFile& file, const std::string& place, const tinygltf::Value& object,
                        const char* key) {
    const tinygltf::Value& info = object.Get(key);
    TextureUse use{place + "." + key};
    if (!info.IsObject()) return use;
    use.index = indexMember(file, use.place, info, "index");
    use.texCoord = std::max(indexMember(file, use.place, info, "texCoord"), 0);
    const tinygltf::Value& extensions = info.Get("extensions");
    if (!extensions.IsObject()) return use;
    const tinygltf::Value& transform = extensions.Get("KHR_texture_transform");
    if (transform.IsObject()) use.transform = &transform;
    return use;
}

/// The textures of a material that are used, each with index -1 where there is none.
struct TextureUses {
    TextureUse color, normal, transmission, emission;
};

std::string materialPlace(std::size_t material) {
    return fmt::format("materials[{}]", material);
}

/// KHR_materials_pbrSpecularGlossiness, whose diffuse colour stands for the base colour; null without it.
const tinygltf::Value* glossinessOf(const GltfFile& file, std::size_t index) {
    return extensionObject(file.model.materials[index].extensions, glossinessExtension);
}

TextureUses usesOf(const GltfFile& file, std::size_t index) {
    const tinygltf::Material& material = file.model.materials[index];
    const std::string place = materialPlace(index);
    TextureUses uses{coreUse(place + ".pbrMetallicRoughness.baseColorTexture",
                             material.pbrMetallicRoughness.baseColorTexture),
                     coreUse(place + ".normalTexture", material.normalTexture),
                     {},
                     coreUse(place + ".emissiveTexture", material.emissiveTexture)};
    if (const auto* object = extensionObject(material.extensions, transmissionExtension))
        uses.transmission = extensionUse(file, fmt::format("{}.{}", place, transmissionExtension), *object,
                                         "transmissionTexture");
    if (const auto* object = glossinessOf(file, index))
        uses.color =
            extensionUse(file, fmt::format("{}.{}", place, glossinessExtension), *object, "diffuseTexture");
    return uses;
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

/// Member `key` of an extension that a material may have, `value` without it.
double extensionFactor(const GltfFile& file, std::size_t index, const char* extension, const char* key,
                       double value) {
    double numbers[1] = {value};
    if (const auto* object = extensionObject(file.model.materials[index].extensions, extension))
        readNumbers(file, fmt::format("{}.{}", materialPlace(index), extension), *object, key, numbers);
    return numbers[0];
}

void convertLight(const GltfFile& file, std::size_t index, Material& material) {
    const double transmission = extensionFactor(file, index, transmissionExtension, "transmissionFactor", 0);
    material.transmission = static_cast<float>(std::clamp(transmission, 0.0, 1.0));
    const double strength =
        extensionFactor(file, index, "KHR_materials_emissive_strength", "emissiveStrength", 1);
    const std::vector<double>& emission = file.model.materials[index].emissiveFactor;
    for (int c = 0; emission.size() == 3 && c < 3; ++c) {
        const std::string place = materialPlace(index) + ".emissiveFactor";
        const float value = finiteFactor(file, place, emission[static_cast<std::size_t>(c)] * strength);
        material.emission[c] = std::max(value, 0.0f);
    }
}

glm::vec4 baseColor(const GltfFile& file, std::size_t index) {
    std::vector<double> factor = file.model.materials[index].pbrMetallicRoughness.baseColorFactor;
    std::string place = materialPlace(index) + ".pbrMetallicRoughness.baseColorFactor";
    if (const auto* object = glossinessOf(file, index)) {
        place = fmt::format("{}.{}", materialPlace(index), glossinessExtension);
        factor = {1, 1, 1, 1};
        readNumbers(file, place, *object, "diffuseFactor", factor);
    }
    glm::vec4 color;
    for (int c = 0; c < 4; ++c)
        color[c] = std::clamp(finiteFactor(file, place, factor.at(static_cast<std::size_t>(c))), 0.0f, 1.0f);
    return color;
}

Material convert(const GltfFile& file, std::size_t index) {
    const tinygltf::Material& source = file.model.materials[index];
    const std::string place = materialPlace(index);
    Material material;
    material.name = source.name;
    material.baseColor = baseColor(file, index);
    // A later version's modes count as the default, as glTF wants it of versions with the same first number.
    if (source.alphaMode == "MASK") material.alphaMode = AlphaMode::Mask;
    if (source.alphaMode == "BLEND") material.alphaMode = AlphaMode::Blend;
    material.alphaCutoff = std::max(finiteFactor(file, place + ".alphaCutoff", source.alphaCutoff), 0.0f);
    material.doubleSided = source.doubleSided;
    material.normalScale = finiteFactor(file, place + ".normalTexture.scale", source.normalTexture.scale);
    convertLight(file, index, material);
    return material;
}

TextureMapping mappingOf(const GltfFile& file, const TextureUse& use) {
    TextureMapping mapping{use.texCoord};
    const tinygltf::Value* object = use.transform;
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

/// The use that says where a material's `uvs` lie: the first of its textures that has a picture.
const TextureUse& uvsOf(const GltfFile& file, const TextureUses& uses) {
    for (const TextureUse* use : {&uses.color, &uses.transmission, &uses.emission})
        if (imageOf(file, *use) >= 0) return *use;
    return imageOf(file, uses.normal) >= 0 ? uses.normal : uses.color;
}

/// A texture on a material's `uvs`: its place in the mesh's images, -1 if there is none.
int addOnUvs(const GltfFile& file, const TextureUses& uses, const TextureUse& use, bool srgb, Mesh& mesh,
             ImageSet& images) {
    const int image = imageOf(file, use);
    if (image < 0) return -1;
    const TextureUse& main = uvsOf(file, uses);
    if (mappingOf(file, use) == mappingOf(file, main)) return images.add(image, srgb);
    addNotice(file, mesh, use.place,
              fmt::format("texture left out: it lies on other coordinates than {}", main.place));
    return -1;
}

/// Notices for textures whose picture is given in an extension's format alone.
void noticeOtherFormats(const GltfFile& file, const TextureUses& uses, Mesh& mesh) {
    for (const TextureUse* use : {&uses.color, &uses.normal, &uses.transmission, &uses.emission}) {
        const tinygltf::Texture* texture = textureOf(file, *use);
        if (!texture || texture->source != -1) continue;
        const std::string place = fmt::format("textures[{}]", use->index);
        if (texture->extensions.empty()) addNotice(file, mesh, place, "texture left out: it has no picture");
        for (const auto& [name, value] : texture->extensions)
            addNotice(file, mesh, place, fmt::format("texture left out: {}: {}", name, unusedReason(name)));
    }
}

/// The textures of the mesh's material `index`, which is in use.
void addTextures(const GltfFile& file, std::size_t index, ImageSet& images, Mesh& mesh) {
    const TextureUses uses = usesOf(file, index);
    noticeOtherFormats(file, uses, mesh);
    Material& material = mesh.materials[index];
    const int normalImage = imageOf(file, uses.normal);
    material.baseColorImage = addOnUvs(file, uses, uses.color, true, mesh, images);
    material.transmissionImage = addOnUvs(file, uses, uses.transmission, false, mesh, images);
    material.emissionImage = addOnUvs(file, uses, uses.emission, true, mesh, images);
    if (normalImage >= 0) material.normalImage = images.add(normalImage, false);
    const auto wrap = [&](const TextureUse& use, Wrap& s, Wrap& t) {
        const tinygltf::Sampler* sampler = samplerOf(file, use);
        if (sampler) s = wrapOf(sampler->wrapS), t = wrapOf(sampler->wrapT);
    };
    wrap(uses.color, material.baseColorWrapS, material.baseColorWrapT);
    wrap(uses.normal, material.normalWrapS, material.normalWrapT);
    wrap(uses.transmission, material.transmissionWrapS, material.transmissionWrapT);
    wrap(uses.emission, material.emissionWrapS, material.emissionWrapT);
    const tinygltf::Sampler* sampler = samplerOf(file, uses.color);
    material.baseColorNearest = sampler && sampler->magFilter == samplerNearest;
}

} // namespace

TextureMappings textureMappings(const GltfFile& file, int material) {
    if (material < 0 || static_cast<std::size_t>(material) >= file.model.materials.size()) return {};
    const TextureUses uses = usesOf(file, static_cast<std::size_t>(material));
    TextureMappings mappings{mappingOf(file, uvsOf(file, uses)), mappingOf(file, uses.normal)};
    if (imageOf(file, uses.normal) < 0) mappings.normal = mappings.color;
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
    ImageSet images(file, mesh);
    for (std::size_t i = 0; i < count; ++i) {
        mesh.materials.push_back(convert(file, i));
        if (used[i]) addTextures(file, i, images, mesh);
    }
    if (used.back() || mesh.materials.empty()) mesh.materials.push_back(Material{glm::vec4(1.0f), -1});
}

} // namespace limpid::io
