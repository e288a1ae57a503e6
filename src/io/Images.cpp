#include "io/Images.h"

#include <algorithm>
#include <cassert>
#include <stdexcept>

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include "core/Error.h"
#include "io/Files.h"

namespace fs = std::filesystem;

namespace limpid::io {

namespace {

/// 16 GiB of floats: more than any map or picture here has, less than what a broken header can claim.
constexpr std::int64_t maxNumbers = std::int64_t(1) << 32;

void writeImage(const fs::path& file, const OIIO::ImageSpec& spec, OIIO::TypeDesc type, const void* data) {
    writeWhole(file, [&](const fs::path& partial) {
        const auto output = OIIO::ImageOutput::create(partial.string());
        if (!output) throw std::runtime_error(OIIO::geterror());
        if (!output->open(partial.string(), spec) || !output->write_image(type, data) || !output->close())
            throw std::runtime_error(output->geterror());
    });
}

[[noreturn]] void failReading(const fs::path& file, const std::string& reason) {
    throw InputError(fmt::format("{}: cannot read: {}", oneLine(file.string()), oneLine(reason)));
}

} // namespace

void writeExr(const fs::path& file, int width, int height, std::vector<std::string> channelNames,
              std::span<const float> data) {
    const auto channels = static_cast<int>(channelNames.size());
    assert(data.size() == std::size_t(width) * std::size_t(height) * std::size_t(channels));
    OIIO::ImageSpec spec(width, height, channels, OIIO::TypeFloat);
    spec.channelnames = std::move(channelNames);
    spec.attribute("compression", "zip");
    // Without one the library writes the time of day, and equal pictures differ byte by byte.
    spec.attribute("DateTime", "1970:01:01 00:00:00");
    writeImage(file, spec, OIIO::TypeFloat, data.data());
}

void writePng(const fs::path& file, int width, int height, std::span<const std::uint8_t> rgb) {
    assert(rgb.size() == std::size_t(width) * std::size_t(height) * 3);
    OIIO::ImageSpec spec(width, height, 3, OIIO::TypeUInt8);
    spec.attribute("oiio:ColorSpace", "sRGB");
    writeImage(file, spec, OIIO::TypeUInt8, rgb.data());
}

Channel readFirstChannel(const fs::path& file, int minSide, int maxSide) {
    requireFile(file);
    OIIO::ImageSpec config;
    config.attribute("oiio:UnassociatedAlpha", 1); // alpha is nothing that a height should be multiplied by
    const auto input = OIIO::ImageInput::open(file.string(), &config);
    if (!input) failReading(file, OIIO::geterror());
    const OIIO::ImageSpec& spec = input->spec();
    if (std::min(spec.width, spec.height) < minSide || std::max(spec.width, spec.height) > maxSide ||
        spec.nchannels < 1 || spec.depth > 1)
        throw InputError(fmt::format("{}: expected {} to {} pixels a side, found {} x {}",
                                     oneLine(file.string()), minSide, maxSide, spec.width, spec.height));
    Channel channel{spec.width, spec.height, spec.channelformat(0).is_floating_point(), {}};
    channel.data.resize(std::size_t(spec.width) * std::size_t(spec.height));
    if (!input->read_image(0, 0, 0, 1, OIIO::TypeFloat, channel.data.data()))
        failReading(file, input->geterror());
    return channel;
}

FloatImage readImage(const fs::path& file) {
    requireFile(file);
    const auto input = OIIO::ImageInput::open(file.string());
    if (!input) failReading(file, OIIO::geterror());
    const OIIO::ImageSpec& spec = input->spec();
    FloatImage image{spec.width,        spec.height, spec.nchannels, spec.format.is_floating_point(),
                     spec.channelnames, {}};
    if (spec.width < 1 || spec.height < 1 || spec.nchannels < 1 || spec.depth > 1)
        failReading(file, "it has no pixels of two dimensions");
    if (std::int64_t(spec.width) * spec.height > maxNumbers / spec.nchannels)
        failReading(file, fmt::format("{} x {} pixels are too many", spec.width, spec.height));
    image.data.resize(std::size_t(spec.width) * std::size_t(spec.height) * std::size_t(spec.nchannels));
    if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeFloat, image.data.data()))
        failReading(file, input->geterror());
    return image;
}

} // namespace limpid::io
