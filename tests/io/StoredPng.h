#pragma once
#include <array>
#include <cstdint>
#include <string>

namespace limpid::test {

inline std::string bigEndian(std::uint32_t value, int bytes = 4) {
    std::string text;
    for (int shift = 8 * (bytes - 1); shift >= 0; shift -= 8)
        text += char(value >> shift & 0xff);
    return text;
}

inline std::string pngChunk(const std::string& name, const std::string& data) {
    std::uint32_t crc = ~0u; // PNG specification, annex D
    for (const char c : name + data) {
        crc ^= std::uint8_t(c);
        for (int bit = 0; bit < 8; ++bit)
            crc = crc & 1 ? 0xEDB88320u ^ crc >> 1 : crc >> 1;
    }
    return bigEndian(std::uint32_t(data.size())) + name + data + bigEndian(~crc);
}

/// The bytes of a PNG file of one colour, `side` x `side` pixels, four channels of 8 or 16 `bits`, not
/// compressed: one block of at most 65,535 bytes.
inline std::string storedPng(int side, int bits, const std::array<std::uint32_t, 4>& color) {
    std::string row(1, '\0'), pixels;
    for (int x = 0; x < side; ++x)
        for (const std::uint32_t channel : color)
            row += bigEndian(channel, bits / 8);
    for (int y = 0; y < side; ++y)
        pixels += row;
    std::uint32_t a = 1, b = 0; // Adler-32, RFC 1950
    for (const char c : pixels)
        a = (a + std::uint8_t(c)) % 65521, b = (b + a) % 65521;
    const auto size = std::uint32_t(pixels.size());
    const std::string zlib = std::string("\x78\x01\x01") + char(size & 0xff) + char(size >> 8) +
                             char(~size & 0xff) + char(~size >> 8 & 0xff) + pixels + bigEndian(b << 16 | a);
    constexpr char rgba = 6;
    return "\x89PNG\r\n\x1a\n" +
           pngChunk("IHDR", bigEndian(std::uint32_t(side)) + bigEndian(std::uint32_t(side)) + char(bits) +
                                rgba + std::string(3, '\0')) +
           pngChunk("IDAT", zlib) + pngChunk("IEND", "");
}

} // namespace limpid::test
