#include "io/images/Images.h"

#include <algorithm>
#include <cassert>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <stdexcept>

#include <fcntl.h>
#include <unistd.h>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include "core/Error.h"
#include "io/Files.h"
#include "io/images/Reading.h"

namespace fs = std::filesystem;

namespace limpid::io {

namespace {

/// The library writes PNG without a look at whether the disk takes it, so it writes to memory, and we to the
/// disk.
/// `format`: the library's name of it.
void writeImage(const fs::path& file, const char* format, const OIIO::ImageSpec& spec, OIIO::TypeDesc type,
                const void* data) {
    writeWhole(file, [&](const fs::path& partial) {
        OIIO::Filesystem::IOVecOutput bytes;
        const auto output = OIIO::ImageOutput::create(format, &bytes);
        if (!output) throw std::runtime_error(OIIO::geterror());
        if (!output->open(partial.string(), spec) || !output->write_image(type, data) || !output->close())
            throw std::runtime_error(output->geterror());
        std::ofstream stream(partial, std::ios::binary);
        stream.write(reinterpret_cast<const char*>(bytes.buffer().data()),
                     std::streamsize(bytes.buffer().size()));
        stream.close();
        if (!stream) throw std::runtime_error(std::strerror(errno));
    });
}

/// While it lives, nothing comes to stderr: libpng puts a line of its own there for what the error then says.
class QuietStderr {
  public:
    QuietStderr() : _kept(::fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, 3)) {
        const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
        if (_kept >= 0 && nowhere >= 0) ::dup2(nowhere, STDERR_FILENO);
        if (nowhere >= 0) ::close(nowhere);
    }
    ~QuietStderr() {
        if (_kept < 0) return;
        ::dup2(_kept, STDERR_FILENO);
        ::close(_kept);
    }
    QuietStderr(const QuietStderr&) = delete;
    QuietStderr& operator=(const QuietStderr&) = delete;

  private:
    int _kept;
};

} // namespace

void writeExr(const fs::path& file, int width, int height, std::vector<std::string> channelNames,
              std::span<const float> data, const std::string& fingerprint) {
    const auto channels = static_cast<int>(channelNames.size());
    assert(data.size() == std::size_t(width) * std::size_t(height) * std::size_t(channels));
    OIIO::ImageSpec spec(width, height, channels, OIIO::TypeFloat);
    spec.channelnames = std::move(channelNames);
    spec.attribute("compression", "zip");
    // Without one the library writes the time of day, and equal pictures differ byte by byte.
    spec.attribute("DateTime", "1970:01:01 00:00:00");
    if (!fingerprint.empty()) spec.attribute(fingerprintKey, fingerprint);
    writeImage(file, "openexr", spec, OIIO::TypeFloat, data.data());
}

void writePng(const fs::path& file, int width, int height, std::span<const std::uint8_t> rgb,
              const std::string& fingerprint) {
    assert(rgb.size() == std::size_t(width) * std::size_t(height) * 3);
    OIIO::ImageSpec spec(width, height, 3, OIIO::TypeUInt8);
    spec.attribute("oiio:ColorSpace", "sRGB");
    if (!fingerprint.empty()) spec.attribute(fingerprintKey, fingerprint);
    writeImage(file, "png", spec, OIIO::TypeUInt8, rgb.data());
}

std::optional<Stamp> readStamp(const fs::path& file) {
    std::error_code error;
    if (!fs::is_regular_file(file, error)) return {};
    const QuietStderr quiet;
    const auto input = OIIO::ImageInput::open(file.string());
    if (!input) {
        OIIO::geterror(); // or it would be the next failure's
        return {};
    }
    const OIIO::ImageSpec& spec = input->spec();
    return Stamp{spec.width, spec.height, std::string(spec.get_string_attribute(fingerprintKey))};
}

Channel readFirstChannel(const fs::path& file, int minSide, int maxSide) {
    requireFile(file);
    const QuietStderr quiet;
    OIIO::ImageSpec config;
    config.attribute("oiio:UnassociatedAlpha", 1); // alpha is nothing that a height should be multiplied by
    const auto input = OIIO::ImageInput::open(file.string(), &config);
    if (!input) failReading(file, OIIO::geterror());
    const OIIO::ImageSpec& spec = input->spec();
    if (std::min(spec.width, spec.height) < minSide || std::max(spec.width, spec.height) > maxSide ||
        spec.nchannels < 1 || spec.depth > 1)
        throw InputError(fmt::format("{}: expected {} to {} pixels a side, found {} x {}",
                                     oneLine(file.string()), minSide, maxSide, spec.width, spec.height));
    Channel channel{spec.width, spec.height, spec.channelformat(0).is_floating_point(), 0, {}};
    const int bits = spec.get_int_attribute("oiio:BitsPerSample", int(8 * spec.channelformat(0).size()));
    if (!channel.floatingPoint) channel.step = 1 / (std::exp2(bits) - 1);
    channel.data.resize(std::size_t(spec.width) * std::size_t(spec.height));
    if (!input->read_image(0, 0, 0, 1, OIIO::TypeFloat, channel.data.data()))
        failReading(file, input->geterror());
    return channel;
}

FloatImage readImage(const fs::path& file) {
    requireFile(file);
    const QuietStderr quiet;
    const auto input = OIIO::ImageInput::open(file.string());
    if (!input) failReading(file, OIIO::geterror());
    const OIIO::ImageSpec& spec = input->spec();
    FloatImage image{spec.width,        spec.height, spec.nchannels, spec.format.is_floating_point(),
                     spec.channelnames, {}};
    if (spec.width < 1 || spec.height < 1 || spec.nchannels < 1 || spec.depth > 1)
        failReading(file, "it has no pixels of two dimensions");
    const std::int64_t most = mostNumbers(std::int64_t(fs::file_size(file)));
    if (std::int64_t(spec.width) * spec.height > most / spec.nchannels)
        failReading(
            file, fmt::format("{} x {} pixels are too many for a file of its size", spec.width, spec.height));
    image.data.resize(std::size_t(spec.width) * std::size_t(spec.height) * std::size_t(spec.nchannels));
    if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeFloat, image.data.data()))
        failReading(file, input->geterror());
    return image;
}

} // namespace limpid::io
