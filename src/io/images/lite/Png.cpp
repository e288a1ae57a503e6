#include "io/images/lite/Decoder.h"

#include <cstring>
#include <stdexcept>

#include <fmt/format.h>
#include <stb_image_write.h>
#include <zlib.h>

#include "io/images/Reading.h"

namespace limpid::io::lite {

namespace {

constexpr std::uint8_t signature[] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
/// Of a chunk, beside its data: length and name before, checksum after.
constexpr std::size_t before = 8, after = 4;

std::uint32_t readBigEndian(Bytes bytes) {
    return std::uint32_t(bytes[0]) << 24 | std::uint32_t(bytes[1]) << 16 | std::uint32_t(bytes[2]) << 8 |
           std::uint32_t(bytes[3]);
}

void addBigEndian(std::vector<std::uint8_t>& bytes, std::uint32_t value) {
    for (const int shift : {24, 16, 8, 0})
        bytes.push_back(std::uint8_t(value >> shift));
}

/// Of a chunk's name and data.
std::uint32_t checksum(Bytes bytes) {
    return std::uint32_t(::crc32_z(::crc32_z(0, nullptr, 0), bytes.data(), bytes.size()));
}

} // namespace

bool isPng(Bytes file) {
    return file.size() > sizeof signature && std::memcmp(file.data(), signature, sizeof signature) == 0;
}

std::vector<PngChunk> pngChunks(Bytes file) {
    std::vector<PngChunk> chunks;
    Bytes rest = file.subspan(sizeof signature);
    while (chunks.empty() || chunks.back().name != "IEND") {
        if (rest.size() < before + after || readBigEndian(rest) > rest.size() - before - after)
            throw std::runtime_error("PNG: it ends within a chunk");
        const std::size_t length = readBigEndian(rest);
        const std::string name(reinterpret_cast<const char*>(rest.data()) + 4, 4);
        if (checksum(rest.subspan(4, 4 + length)) != readBigEndian(rest.subspan(before + length)))
            throw std::runtime_error(fmt::format("PNG: the checksum of its chunk {} is wrong", name));
        chunks.push_back({name, rest.subspan(before, length)});
        rest = rest.subspan(before + length + after);
    }
    return chunks;
}

std::vector<std::uint8_t> encodeChunk(const std::string& name, const std::string& data) {
    std::vector<std::uint8_t> bytes;
    addBigEndian(bytes, std::uint32_t(data.size()));
    bytes.insert(bytes.end(), name.begin(), name.end());
    bytes.insert(bytes.end(), data.begin(), data.end());
    addBigEndian(bytes, checksum(Bytes(bytes).subspan(4)));
    return bytes;
}

std::vector<std::uint8_t> encodePng(int width, int height, std::span<const std::uint8_t> rgb,
                                    const std::string& fingerprint) {
    std::vector<std::uint8_t> bytes;
    const auto add = [](void* to, void* data, int size) {
        const auto* const start = static_cast<const std::uint8_t*>(data);
        auto& all = *static_cast<std::vector<std::uint8_t>*>(to);
        all.insert(all.end(), start, start + size);
    };
    if (!::stbi_write_png_to_func(add, &bytes, width, height, 3, rgb.data(), 3 * width))
        throw std::runtime_error("PNG: there is no memory for it");
    std::vector<std::uint8_t> extra = encodeChunk("sRGB", std::string(1, '\0'));
    if (!fingerprint.empty()) {
        const auto text = encodeChunk("tEXt", fingerprintKey + std::string(1, '\0') + fingerprint);
        extra.insert(extra.end(), text.begin(), text.end());
    }
    constexpr std::size_t header = sizeof signature + before + 13 + after; // the chunk IHDR is first
    bytes.insert(bytes.begin() + header, extra.begin(), extra.end());
    return bytes;
}

} // namespace limpid::io::lite
