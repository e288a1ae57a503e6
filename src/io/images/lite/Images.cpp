#include "io/images/Images.h"

#include <algorithm>
#include <cassert>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <stdexcept>

#include <fmt/format.h>

#include "core/Error.h"
#include "io/Files.h"
#include "io/images/Reading.h"
#include "io/images/lite/Decoder.h"

namespace fs = std::filesystem;

namespace limpid::io {

namespace {

using namespace lite;

void writeBytes(const fs::path& file, const std::function<std::vector<std::uint8_t>()>& encode) {
    writeWhole(file, [&](const fs::path& partial) {
        const std::vector<std::uint8_t> bytes = encode();
        std::ofstream stream(partial, std::ios::binary);
        stream.write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
        stream.close();
        if (!stream) throw std::runtime_error(std::strerror(errno));
    });
}

Head headOf(Bytes bytes) {
    return isExr(bytes) ? exrHead(bytes) : stbHead(bytes);
}

/// Throws std::runtime_error, also if they are more than a file of so many bytes can stand for.
std::vector<float> pixelsOf(Bytes bytes, const Head& head) {
    const auto channels = std::int64_t(head.channelNames.size());
    const std::int64_t most = mostNumbers(std::int64_t(bytes.size()));
    if (channels < 1) throw std::runtime_error("it has no pixels of two dimensions");
    if (std::int64_t(head.width) * head.height > most / channels)
        throw std::runtime_error(
            fmt::format("{} x {} pixels are too many for a file of its size", head.width, head.height));
    std::vector<float> data = isExr(bytes) ? exrPixels(bytes) : stbPixels(bytes);
    if (data.size() != std::size_t(head.width) * std::size_t(head.height) * std::size_t(channels))
        throw std::runtime_error("it has not the pixels that its header tells of");
    return data;
}

} // namespace

void writeExr(const fs::path& file, int width, int height, std::vector<std::string> channelNames,
              std::span<const float> data, const std::string& fingerprint) {
    assert(data.size() == std::size_t(width) * std::size_t(height) * channelNames.size());
    writeBytes(file, [&] { return encodeExr(width, height, channelNames, data, fingerprint); });
}

void writePng(const fs::path& file, int width, int height, std::span<const std::uint8_t> rgb,
              const std::string& fingerprint) {
    assert(rgb.size() == std::size_t(width) * std::size_t(height) * 3);
    writeBytes(file, [&] { return encodePng(width, height, rgb, fingerprint); });
}

std::optional<Stamp> readStamp(const fs::path& file) {
    std::error_code error;
    if (!fs::is_regular_file(file, error)) return {};
    try {
        Head head = headOf(readBytes(file));
        return Stamp{head.width, head.height, std::move(head.fingerprint)};
    } catch (const std::runtime_error&) {
        return {};
    }
}

Channel readFirstChannel(const fs::path& file, int minSide, int maxSide) {
    const std::vector<std::uint8_t> bytes = readBytes(file);
    try {
        const Head head = headOf(bytes);
        if (std::min(head.width, head.height) < minSide || std::max(head.width, head.height) > maxSide)
            throw InputError(fmt::format("{}: expected {} to {} pixels a side, found {} x {}",
                                         oneLine(file.string()), minSide, maxSide, head.width, head.height));
        Channel channel{head.width, head.height, head.floatingPoint, 0, {}};
        if (!channel.floatingPoint) channel.step = 1 / (std::exp2(head.bits) - 1);
        const std::vector<float> all = pixelsOf(bytes, head);
        for (std::size_t i = 0; i < all.size(); i += head.channelNames.size())
            channel.data.push_back(all[i]);
        return channel;
    } catch (const InputError&) {
        throw;
    } catch (const std::exception& error) {
        failReading(file, error.what());
    }
}

FloatImage readImage(const fs::path& file) {
    const std::vector<std::uint8_t> bytes = readBytes(file);
    try {
        Head head = headOf(bytes);
        std::vector<float> data = pixelsOf(bytes, head);
        return {head.width,
                head.height,
                int(head.channelNames.size()),
                head.floatingPoint,
                std::move(head.channelNames),
                std::move(data)};
    } catch (const std::exception& error) {
        failReading(file, error.what());
    }
}

} // namespace limpid::io
