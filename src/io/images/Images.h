#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

/// Pictures in and out. Rows run from the top, channels are interleaved. Files appear whole or not at all.
namespace limpid::io {

/// `data` holds width · height · channels numbers, as stored in the file: 8- and 16-bit integers scaled to
/// [0, 1], no colour conversion.
struct FloatImage {
    int width = 0;
    int height = 0;
    int channels = 0;
    bool floatingPoint = false; ///< how the file stores it
    std::vector<std::string> channelNames;
    std::vector<float> data;
};

/// Writes float32 OpenEXR, zip-compressed. `data` holds width · height · channelNames.size() numbers.
/// `fingerprint`: see `readStamp`; empty for none. Throws InputError if the file cannot be written.
void writeExr(const std::filesystem::path& file, int width, int height, std::vector<std::string> channelNames,
              std::span<const float> data, const std::string& fingerprint = "");

/// Writes 8-bit sRGB. `rgb` holds width · height · 3 bytes. Throws InputError if the file cannot be written.
void writePng(const std::filesystem::path& file, int width, int height, std::span<const std::uint8_t> rgb,
              const std::string& fingerprint = "");

/// The header of a picture.
struct Stamp {
    int width = 0;
    int height = 0;
    std::string fingerprint; ///< as it was written; empty if there was none
};

/// None for what is no picture.
std::optional<Stamp> readStamp(const std::filesystem::path& file);

/// The first channel of a picture, row by row from the top.
struct Channel {
    int width = 0;
    int height = 0;
    bool floatingPoint = false; ///< how the file stores it; integers come scaled to [0, 1]
    double step = 0;            ///< of integers, scaled: 1/255 with 8 bits; 0 for floating point
    std::vector<float> data;
};

/// Reads just the first channel of a picture of `minSide` to `maxSide` pixels a side. Throws InputError if it
/// cannot be read, or is of another size.
Channel readFirstChannel(const std::filesystem::path& file, int minSide, int maxSide);

/// Reads the first picture of any file that OpenImageIO knows; built with LIMPID_IMAGES=lite, of PNG, OpenEXR
/// and the few formats that stb knows. Throws InputError if it cannot be read.
FloatImage readImage(const std::filesystem::path& file);

} // namespace limpid::io
