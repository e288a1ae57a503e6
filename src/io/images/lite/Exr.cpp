#include "io/images/lite/Decoder.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <numeric>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>
#include <tinyexr.h>

#include "io/images/Reading.h"

namespace limpid::io::lite {

namespace {

constexpr int halfBits = 16, wordBits = 32;

/// Throws what tinyexr says of it, if it says no success.
void require(bool success, const char* message) {
    if (success) return;
    const std::string text = message ? message : "OpenEXR: it is broken";
    ::FreeEXRErrorMessage(message);
    throw std::runtime_error(text);
}

struct Header : ::EXRHeader {
    explicit Header(Bytes file) {
        ::InitEXRHeader(this);
        ::EXRVersion version;
        if (::ParseEXRVersionFromMemory(&version, file.data(), file.size()) != TINYEXR_SUCCESS)
            throw std::runtime_error("OpenEXR: expected version 2");
        if (version.tiled || version.multipart || version.non_image)
            throw std::runtime_error("this build reads OpenEXR of one part in scan lines only: built with "
                                     "LIMPID_IMAGES=lite");
        const char* message = nullptr;
        require(::ParseEXRHeaderFromMemory(this, &version, file.data(), file.size(), &message) ==
                    TINYEXR_SUCCESS,
                message);
    }
    ~Header() { ::FreeEXRHeader(this); }
    Header(const Header&) = delete;
    Header& operator=(const Header&) = delete;
};

struct Pixels : ::EXRImage {
    Pixels(const Header& header, Bytes file) {
        ::InitEXRImage(this);
        const char* message = nullptr;
        require(::LoadEXRImageFromMemory(this, &header, file.data(), file.size(), &message) ==
                    TINYEXR_SUCCESS,
                message);
    }
    ~Pixels() { ::FreeEXRImage(this); }
    Pixels(const Pixels&) = delete;
    Pixels& operator=(const Pixels&) = delete;
};

/// Files list channels by name; colours are handed on as R, G, B, A.
std::vector<int> order(const Header& header) {
    static const std::string colors = "RGBYA";
    const auto rank = [&](int channel) {
        const std::string name = header.channels[channel].name;
        return name.size() == 1 ? std::min(colors.find(name), colors.size()) : colors.size();
    };
    std::vector<int> channels(std::size_t(header.num_channels));
    std::iota(channels.begin(), channels.end(), 0);
    std::stable_sort(channels.begin(), channels.end(), [&](int a, int b) { return rank(a) < rank(b); });
    return channels;
}

std::string fingerprintOf(const Header& header) {
    for (int i = 0; i < header.num_custom_attributes; ++i) {
        const ::EXRAttribute& attribute = header.custom_attributes[i];
        if (std::strcmp(attribute.name, fingerprintKey) == 0 && std::strcmp(attribute.type, "string") == 0)
            return {reinterpret_cast<const char*>(attribute.value), std::size_t(attribute.size)};
    }
    return {};
}

} // namespace

bool isExr(Bytes file) {
    constexpr std::uint8_t magic[] = {0x76, 0x2f, 0x31, 0x01};
    return file.size() > sizeof magic && std::memcmp(file.data(), magic, sizeof magic) == 0;
}

Head exrHead(Bytes file) {
    const Header header(file);
    const ::EXRBox2i& box = header.data_window;
    const std::int64_t width = std::int64_t(box.max_x) - box.min_x + 1,
                       height = std::int64_t(box.max_y) - box.min_y + 1;
    constexpr std::int64_t most = 1 << 30;
    if (width < 1 || height < 1 || width > most || height > most)
        throw std::runtime_error("OpenEXR: its data window is broken");
    Head head{int(width), int(height), {}, true, 0, fingerprintOf(header)};
    for (const int channel : order(header)) {
        const ::EXRChannelInfo& info = header.channels[channel];
        if (info.x_sampling != 1 || info.y_sampling != 1)
            throw std::runtime_error(fmt::format("OpenEXR: its channel {} is subsampled", info.name));
        if (info.pixel_type == TINYEXR_PIXELTYPE_UINT)
            throw std::runtime_error(fmt::format("OpenEXR: its channel {} holds integers", info.name));
        head.channelNames.emplace_back(info.name);
        head.bits = std::max(head.bits, info.pixel_type == TINYEXR_PIXELTYPE_HALF ? halfBits : wordBits);
    }
    return head;
}

std::vector<float> exrPixels(Bytes file) {
    Header header(file);
    for (int channel = 0; channel < header.num_channels; ++channel)
        header.requested_pixel_types[channel] = TINYEXR_PIXELTYPE_FLOAT;
    const Pixels pixels(header, file);
    const std::vector<int> channels = order(header);
    const std::size_t count = std::size_t(pixels.width) * std::size_t(pixels.height);
    std::vector<float> data(count * channels.size());
    for (std::size_t c = 0; c < channels.size(); ++c) {
        const auto* const plane = reinterpret_cast<const float*>(pixels.images[channels[c]]);
        for (std::size_t i = 0; i < count; ++i)
            data[i * channels.size() + c] = plane[i];
    }
    return data;
}

std::vector<std::uint8_t> encodeExr(int width, int height, const std::vector<std::string>& channelNames,
                                    std::span<const float> data, const std::string& fingerprint) {
    const std::size_t count = channelNames.size(), pixels = std::size_t(width) * std::size_t(height);
    std::vector<std::size_t> byName(count);
    std::iota(byName.begin(), byName.end(), 0u);
    std::sort(byName.begin(), byName.end(),
              [&](std::size_t a, std::size_t b) { return channelNames[a] < channelNames[b]; });

    std::vector<::EXRChannelInfo> infos(count);
    std::vector<std::vector<float>> planes(count, std::vector<float>(pixels));
    std::vector<unsigned char*> images;
    for (std::size_t c = 0; c < count; ++c) {
        const std::string& name = channelNames[byName[c]];
        name.copy(infos[c].name, sizeof infos[c].name - 1); // the rest is 0
        for (std::size_t i = 0; i < pixels; ++i)
            planes[c][i] = data[i * count + byName[c]];
        images.push_back(reinterpret_cast<unsigned char*>(planes[c].data()));
    }
    std::vector<int> types(count, TINYEXR_PIXELTYPE_FLOAT);
    std::string text = fingerprint;
    ::EXRAttribute attribute{};
    std::strcpy(attribute.name, fingerprintKey);
    std::strcpy(attribute.type, "string");
    attribute.value = reinterpret_cast<unsigned char*>(text.data());
    attribute.size = int(text.size());

    ::EXRHeader header;
    ::InitEXRHeader(&header);
    header.num_channels = int(count);
    header.channels = infos.data();
    header.pixel_types = header.requested_pixel_types = types.data();
    header.compression_type = TINYEXR_COMPRESSIONTYPE_ZIP;
    header.num_custom_attributes = fingerprint.empty() ? 0 : 1;
    header.custom_attributes = &attribute;
    ::EXRImage image;
    ::InitEXRImage(&image);
    image.width = width;
    image.height = height;
    image.num_channels = int(count);
    image.images = images.data();

    unsigned char* bytes = nullptr;
    const char* message = nullptr;
    const std::size_t size = ::SaveEXRImageToMemory(&image, &header, &bytes, &message);
    require(size > 0, message);
    const std::unique_ptr<unsigned char, decltype(&std::free)> owner(bytes, &std::free);
    return {bytes, bytes + size};
}

} // namespace limpid::io::lite
