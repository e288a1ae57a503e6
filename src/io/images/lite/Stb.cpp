#include "io/images/lite/Decoder.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <stdexcept>
#include <type_traits>

#include <stb_image.h>

#include "io/images/Reading.h"

namespace limpid::io::lite {

namespace {

constexpr int byteBits = 8;

/// As OpenImageIO calls them.
std::vector<std::string> namesOf(int channels) {
    if (channels == 1) return {"Y"};
    if (channels == 2) return {"Y", "A"};
    if (channels == 3) return {"R", "G", "B"};
    return {"R", "G", "B", "A"};
}

/// Bits of a sample, and the fingerprint.
void readChunks(Bytes file, Head& head) {
    constexpr std::uint8_t palette = 3;
    const std::string key = fingerprintKey + std::string(1, '\0');
    for (const PngChunk& chunk : pngChunks(file)) {
        const std::string text(chunk.data.begin(), chunk.data.end());
        if (chunk.name == "IHDR" && chunk.data.size() > 9 && chunk.data[9] != palette)
            head.bits = chunk.data[8];
        if (chunk.name == "tEXt" && text.starts_with(key)) head.fingerprint = text.substr(key.size());
    }
}

template <typename T>
std::vector<float> scaled(T* pixels, int width, int height, int channels) {
    const std::unique_ptr<T, decltype(&::stbi_image_free)> owner(pixels, &::stbi_image_free);
    if (!pixels) throw std::runtime_error(::stbi_failure_reason());
    const std::size_t count = std::size_t(width) * std::size_t(height) * std::size_t(channels);
    std::vector<float> data(pixels, pixels + count);
    if constexpr (!std::is_floating_point_v<T>)
        for (float& value : data)
            value /= float(std::numeric_limits<T>::max());
    return data;
}

} // namespace

Head stbHead(Bytes file) {
    Head head{0, 0, {}, false, byteBits, {}};
    if (isPng(file)) readChunks(file, head);
    int channels = 0;
    if (file.size() > std::size_t(std::numeric_limits<int>::max()) ||
        !::stbi_info_from_memory(file.data(), int(file.size()), &head.width, &head.height, &channels))
        throw std::runtime_error(
            "this build reads only PNG, OpenEXR, JPEG, BMP, TGA, GIF, PSD, HDR and PNM: built "
            "with LIMPID_IMAGES=lite");
    head.channelNames = namesOf(channels);
    head.floatingPoint = ::stbi_is_hdr_from_memory(file.data(), int(file.size()));
    if (::stbi_is_16_bit_from_memory(file.data(), int(file.size()))) head.bits = 2 * byteBits;
    return head;
}

std::vector<float> stbPixels(Bytes file) {
    int width = 0, height = 0, channels = 0;
    const auto load = [&](auto* function) {
        auto* const pixels = function(file.data(), int(file.size()), &width, &height, &channels, 0);
        return scaled(pixels, width, height, channels);
    };
    if (::stbi_is_hdr_from_memory(file.data(), int(file.size()))) return load(::stbi_loadf_from_memory);
    if (::stbi_is_16_bit_from_memory(file.data(), int(file.size()))) return load(::stbi_load_16_from_memory);
    return load(::stbi_load_from_memory);
}

} // namespace limpid::io::lite
