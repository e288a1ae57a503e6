#include "io/gltf/Images.h"

#include <algorithm>
#include <cstring>

#include <fmt/format.h>

#include "io/Files.h"
#include "io/gltf/Accessor.h"
#include "io/gltf/Notices.h"

namespace limpid::io {

namespace {

constexpr std::size_t maxEncodedBytes = 1u << 30; ///< tinygltf counts them in an int
constexpr int maxSide = 16384;
constexpr std::size_t maxPixels = std::size_t(1) << 28; ///< of all pictures of a file, 1 GiB

int readBigEndian(std::span<const std::uint8_t> bytes, std::size_t at, std::size_t count) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < count; ++i)
        value = value << 8 | bytes[at + i];
    return static_cast<int>(std::min(value, 0x7FFFFFFFu));
}

std::optional<glm::ivec2> pngSize(std::span<const std::uint8_t> bytes) {
    constexpr std::uint8_t start[] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n',
                                      0,    0,   0,   13,  'I',  'H',  'D',  'R'};
    if (bytes.size() < sizeof start + 8 || std::memcmp(bytes.data(), start, sizeof start) != 0)
        return std::nullopt;
    return glm::ivec2(readBigEndian(bytes, sizeof start, 4), readBigEndian(bytes, sizeof start + 4, 4));
}

/// Goes from segment to segment until the one that starts a frame, as the decoder does.
std::optional<glm::ivec2> jpegSize(std::span<const std::uint8_t> bytes) {
    if (bytes.size() < 2 || bytes[0] != 0xFF || bytes[1] != 0xD8) return std::nullopt;
    std::size_t at = 2;
    while (true) {
        while (at < bytes.size() && bytes[at] != 0xFF)
            ++at;
        while (at < bytes.size() && bytes[at] == 0xFF)
            ++at;
        if (at + 8 > bytes.size()) return std::nullopt;
        const std::uint8_t marker = bytes[at++];
        const auto length = static_cast<std::size_t>(readBigEndian(bytes, at, 2));
        if (marker >= 0xC0 && marker <= 0xC2) // baseline, extended, progressive: what is decoded at all
            return glm::ivec2(readBigEndian(bytes, at + 5, 2), readBigEndian(bytes, at + 3, 2));
        if (length < 2) return std::nullopt;
        at += length;
    }
}

std::uint8_t reduceTo8Bits(const unsigned char* bytes) {
    std::uint16_t value;
    std::memcpy(&value, bytes, sizeof value);
    return static_cast<std::uint8_t>((value + 128) / 257);
}

/// Why a picture is not to be decoded; empty if it is.
std::string objection(const std::string& uri, std::span<const std::uint8_t> encoded,
                      std::size_t pixelsBefore) {
    if (encoded.empty() && !uri.empty() && !uri.starts_with("data:"))
        return fmt::format("no file of the model's folder is \"{}\"", oneLine(uri, 80));
    if (encoded.size() > maxEncodedBytes) return "it is too large";
    const std::optional<glm::ivec2> size = pictureSize(encoded);
    if (!size) return "it is neither PNG nor JPEG";
    if (size->x < 1 || size->y < 1 || size->x > maxSide || size->y > maxSide)
        return fmt::format("it has {} x {} pixels, not 1 to {} on a side", size->x, size->y, maxSide);
    const std::size_t pixels = static_cast<std::size_t>(size->x) * static_cast<std::size_t>(size->y);
    if (pixels > maxPixels - pixelsBefore)
        return fmt::format("the file's pictures have more than {} pixels", maxPixels);
    return {};
}

} // namespace

std::optional<glm::ivec2> pictureSize(std::span<const std::uint8_t> encoded) {
    const std::optional<glm::ivec2> size = pngSize(encoded);
    return size ? size : jpegSize(encoded);
}

std::optional<Image> ImageSet::decode(int index) {
    const tinygltf::Image& source = _file.model.images[static_cast<std::size_t>(index)];
    const std::string place = fmt::format("images[{}]", index);
    std::span<const std::uint8_t> encoded(source.image);
    if (source.bufferView >= 0) encoded = bufferViewBytes(_file, place + ".bufferView", source.bufferView);
    tinygltf::Image decoded;
    std::string error = objection(source.uri, encoded, _pixels), warning;
    if (!error.empty() || !tinygltf::LoadImageData(&decoded, index, &error, &warning, 0, 0, encoded.data(),
                                                   static_cast<int>(encoded.size()), nullptr)) {
        addNotice(_file, _mesh, place, "texture left out: " + oneLine(error));
        return std::nullopt;
    }
    Image image{decoded.width, decoded.height, std::move(decoded.image)};
    if (decoded.bits == 16) {
        const std::size_t count = image.rgba.size() / 2;
        for (std::size_t i = 0; i < count; ++i)
            image.rgba[i] = reduceTo8Bits(&image.rgba[2 * i]);
        image.rgba.resize(count);
        image.rgba.shrink_to_fit();
    }
    _pixels += image.rgba.size() / 4;
    return image;
}

int ImageSet::add(int index, bool srgb) {
    const auto [known, isNew] = _known.try_emplace({index, srgb}, -1);
    if (!isNew) return known->second;
    if (const auto other = _known.find({index, !srgb}); other != _known.end() && other->second == -1)
        return -1; // it has been complained of
    std::optional<Image> image = decode(index);
    if (!image) return -1;
    image->srgb = srgb;
    known->second = static_cast<int>(_mesh.images.size());
    _mesh.images.push_back(std::move(*image));
    return known->second;
}

} // namespace limpid::io
