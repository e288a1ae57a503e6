#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

/// Reading and writing in memory, by tinyexr and stb in place of OpenImageIO (LIMPID_IMAGES=lite). Functions
/// throw std::runtime_error with a reason that names no file.
namespace limpid::io::lite {

using Bytes = std::span<const std::uint8_t>;

/// The header of a picture.
struct Head {
    int width = 0;
    int height = 0;
    std::vector<std::string> channelNames; ///< in the order of the pixels' numbers
    bool floatingPoint = false;            ///< how the file stores it
    int bits = 0;                          ///< of an integer, as the file stores it
    std::string fingerprint;               ///< see Images.h
};

/// OpenEXR: one part, scan lines.
bool isExr(Bytes file);
Head exrHead(Bytes file);
/// width · height · channels numbers, row by row from the top. Allocates what the header claims.
std::vector<float> exrPixels(Bytes file);
std::vector<std::uint8_t> encodeExr(int width, int height, const std::vector<std::string>& channelNames,
                                    std::span<const float> data, const std::string& fingerprint);

/// Formats that stb reads: PNG, JPEG, BMP, TGA, GIF, PSD, HDR, PNM. Integers come scaled to [0, 1]; alpha
/// multiplies nothing.
Head stbHead(Bytes file);
std::vector<float> stbPixels(Bytes file);
std::vector<std::uint8_t> encodePng(int width, int height, std::span<const std::uint8_t> rgb,
                                    const std::string& fingerprint);

/// A chunk of a PNG file: its four letters and its data.
struct PngChunk {
    std::string name;
    Bytes data;
};
bool isPng(Bytes file);
/// All chunks, their checksums tested, which stb leaves.
std::vector<PngChunk> pngChunks(Bytes file);
std::vector<std::uint8_t> encodeChunk(const std::string& name, const std::string& data);

} // namespace limpid::io::lite
