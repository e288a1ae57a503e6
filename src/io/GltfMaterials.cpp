#include "io/GltfMaterials.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <map>
#include <optional>
#include <span>

#include <fmt/format.h>

#include "io/Files.h"
#include "io/GltfAccessor.h"

namespace limpid::io {

namespace {

constexpr std::size_t maxEncodedBytes = 1u << 30; ///< tinygltf counts them in an int

std::uint8_t reduceTo8Bits(const unsigned char* bytes) {
    std::uint16_t value;
    std::memcpy(&value, bytes, sizeof value);
    return static_cast<std::uint8_t>((value + 128) / 257);
}

std::optional<Image> decode(const GltfFile& file, int index) {
    const tinygltf::Image& source = file.model.images[static_cast<std::size_t>(index)];
    const std::string place = fmt::format("images[{}]", index);
    std::span<const std::uint8_t> encoded(source.image);
    if (source.bufferView >= 0) encoded = bufferViewBytes(file, place + ".bufferView", source.bufferView);
    tinygltf::Image decoded;
    std::string error, warning;
    if (encoded.empty()) error = "it could not be read";
    if (encoded.size() > maxEncodedBytes) error = "it is too large";
    if (!error.empty() || !tinygltf::LoadImageData(&decoded, index, &error, &warning, 0, 0, encoded.data(),
                                                   static_cast<int>(encoded.size()), nullptr)) {
        fmt::print(stderr, "{}: {}: warning: texture left out: {}\n", file.name, place, oneLine(error));
        return std::nullopt;
    }
    Image image{decoded.width, decoded.height, std::move(decoded.image)};
    if (decoded.bits == 16) {
        const std::size_t count = image.rgba.size() / 2;
        for (std::size_t i = 0; i < count; ++i)
            image.rgba[i] = reduceTo8Bits(&image.rgba[2 * i]);
        image.rgba.resize(count);
    }
    return image;
}

/// The file's image behind a material's base colour, -1 for none.
int imageOf(const GltfFile& file, const std::string& place, const tinygltf::TextureInfo& info) {
    if (info.index == -1) return -1;
    file.requireIndex(place + ".index", info.index, file.model.textures.size());
    const int source = file.model.textures[static_cast<std::size_t>(info.index)].source;
    if (source == -1) return -1;
    file.requireIndex(fmt::format("textures[{}].source", info.index), source, file.model.images.size());
    return source;
}

Material convert(const GltfFile& file, const std::string& place,
                 const tinygltf::PbrMetallicRoughness& source) {
    Material material;
    for (int c = 0; c < 4; ++c) {
        const double factor = source.baseColorFactor.at(static_cast<std::size_t>(c));
        if (!std::isfinite(factor))
            file.fail(place + ".baseColorFactor", "finite numbers", fmt::format("{}", factor));
        material.baseColor[c] = static_cast<float>(std::clamp(factor, 0.0, 1.0));
    }
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

} // namespace

TextureMapping textureMapping(const GltfFile& file, int material) {
    TextureMapping mapping;
    if (material < 0 || static_cast<std::size_t>(material) >= file.model.materials.size()) return mapping;
    const auto& info =
        file.model.materials[static_cast<std::size_t>(material)].pbrMetallicRoughness.baseColorTexture;
    mapping.texCoord = info.texCoord;
    const auto extension = info.extensions.find("KHR_texture_transform");
    if (extension == info.extensions.end() || !extension->second.IsObject()) return mapping;
    const tinygltf::Value& object = extension->second;
    const std::string place =
        fmt::format("materials[{}].pbrMetallicRoughness.baseColorTexture.KHR_texture_transform", material);
    double offset[2] = {0, 0}, scale[2] = {1, 1}, rotation[1] = {0}, texCoord[1] = {double(info.texCoord)};
    readNumbers(file, place, object, "offset", offset);
    readNumbers(file, place, object, "scale", scale);
    readNumbers(file, place, object, "rotation", rotation);
    readNumbers(file, place, object, "texCoord", texCoord);
    mapping.texCoord = static_cast<int>(std::clamp(texCoord[0], 0.0, 1e6));
    // The sign is that of the Khronos sample viewer: counter-clockwise in the picture, whose v points down.
    const double c = std::cos(rotation[0]), s = std::sin(rotation[0]);
    mapping.transform =
        glm::dmat3(c * scale[0], -s * scale[0], 0, s * scale[1], c * scale[1], 0, offset[0], offset[1], 1);
    return mapping;
}

int materialIndex(const GltfFile& file, const std::string& place, const tinygltf::Primitive& primitive) {
    const std::size_t count = file.model.materials.size();
    if (primitive.material == -1) return static_cast<int>(count);
    file.requireIndex(place + ".material", primitive.material, count);
    return primitive.material;
}

void addMaterials(const GltfFile& file, Mesh& mesh) {
    const auto& sources = file.model.materials;
    std::vector<bool> used(sources.size() + 1, false);
    for (const MeshPart& part : mesh.parts)
        used[static_cast<std::size_t>(part.material)] = true;
    std::map<int, int> decoded; // the file's image to the mesh's, -1 for one that cannot be had
    for (std::size_t i = 0; i < sources.size(); ++i) {
        const std::string place = fmt::format("materials[{}].pbrMetallicRoughness", i);
        const tinygltf::PbrMetallicRoughness& source = sources[i].pbrMetallicRoughness;
        mesh.materials.push_back(convert(file, place, source));
        const int index = used[i] ? imageOf(file, place + ".baseColorTexture", source.baseColorTexture) : -1;
        if (index < 0) continue;
        if (!decoded.contains(index)) {
            std::optional<Image> image = decode(file, index);
            decoded[index] = image ? static_cast<int>(mesh.images.size()) : -1;
            if (image) mesh.images.push_back(std::move(*image));
        }
        mesh.materials.back().baseColorImage = decoded[index];
    }
    if (used.back() || mesh.materials.empty()) mesh.materials.push_back(Material{glm::vec4(1.0f), -1});
}

} // namespace limpid::io
