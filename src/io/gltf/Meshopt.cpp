#include "io/gltf/Meshopt.h"

#include <algorithm>
#include <cstring>
#include <span>

#include <fmt/format.h>
#include <meshoptimizer.h>

#include "io/Files.h"
#include "io/gltf/Compressed.h"

namespace limpid::io {

namespace {

/// A view's extension, as it stands in the file.
struct Stream {
    std::string place;
    std::span<const std::uint8_t> bytes;
    std::size_t count = 0;
    std::size_t stride = 0;
    std::string mode;
    std::string filter;
};

std::string text(const tinygltf::Value& object, const char* key, const char* otherwise) {
    return object.Get(key).IsString() ? object.Get(key).Get<std::string>() : otherwise;
}

Stream readStream(const GltfFile& file, const std::string& place, const tinygltf::Value& object) {
    Stream stream;
    stream.place = place;
    const int index = indexMember(file, place, object, "buffer");
    file.requireIndex(place + ".buffer", index, file.model.buffers.size());
    const auto& data = file.model.buffers[static_cast<std::size_t>(index)].data;
    const std::size_t offset = sizeMember(file, place, object, "byteOffset", false);
    const std::size_t length = sizeMember(file, place, object, "byteLength", true);
    if (offset > data.size() || length > data.size() - offset)
        file.fail(place, fmt::format("a range inside of its buffer's {} bytes", data.size()),
                  fmt::format("{} bytes from {}", length, offset));
    stream.bytes = {data.data() + offset, length};
    stream.count = sizeMember(file, place, object, "count", true);
    stream.stride = sizeMember(file, place, object, "byteStride", true);
    stream.mode = text(object, "mode", "");
    stream.filter = text(object, "filter", "NONE");
    return stream;
}

/// The rules of the extension, which the decoder takes for granted.
void checkStride(const GltfFile& file, const Stream& stream) {
    const auto require = [&](bool good, const char* expected) {
        if (!good) file.fail(stream.place + ".byteStride", expected, fmt::format("{}", stream.stride));
    };
    const std::size_t stride = stream.stride;
    if (stream.mode != "ATTRIBUTES")
        require(stride == 2 || stride == 4, "2 or 4 for indices");
    else if (stream.filter == "OCTAHEDRAL" || stream.filter == "COLOR")
        require(stride == 4 || stride == 8, "4 or 8 for its filter");
    else if (stream.filter == "QUATERNION")
        require(stride == 8, "8 for its filter");
    else
        require(stride % 4 == 0 && stride >= 4 && stride <= 256, "a multiple of 4 from 4 to 256");
}

void checkStream(const GltfFile& file, const Stream& stream) {
    const auto requireOne = [&](const char* key, const std::string& found,
                                std::initializer_list<const char*> names) {
        if (std::find(names.begin(), names.end(), found) == names.end())
            file.fail(stream.place + "." + key, fmt::format("{}", fmt::join(names, ", ")),
                      fmt::format("\"{}\"", oneLine(found, 40)));
    };
    requireOne("mode", stream.mode, {"ATTRIBUTES", "TRIANGLES", "INDICES"});
    if (stream.mode == "ATTRIBUTES")
        requireOne("filter", stream.filter, {"NONE", "OCTAHEDRAL", "QUATERNION", "EXPONENTIAL", "COLOR"});
    else
        requireOne("filter", stream.filter, {"NONE"});
    checkStride(file, stream);
    if (stream.mode == "TRIANGLES" && stream.count % 3 != 0)
        file.fail(stream.place + ".count", "a multiple of 3", fmt::format("{}", stream.count));
}

bool decode(const Stream& stream, unsigned char* to) {
    const auto& [place, bytes, count, stride, mode, filter] = stream;
    if (mode == "ATTRIBUTES")
        return meshopt_decodeVertexBuffer(to, count, stride, bytes.data(), bytes.size()) == 0;
    if (mode == "TRIANGLES")
        return meshopt_decodeIndexBuffer(to, count, stride, bytes.data(), bytes.size()) == 0;
    return meshopt_decodeIndexSequence(to, count, stride, bytes.data(), bytes.size()) == 0;
}

/// KHR_meshopt_compression's COLOR: Y, Co and Cg with sign, and alpha, whose highest bit set is the scale.
template <typename T, typename Signed>
void decodeColors(unsigned char* data, std::size_t count) {
    constexpr int largest = (1 << (8 * sizeof(T))) - 1;
    for (std::size_t i = 0; i < count; ++i) {
        T pixel[4];
        unsigned char* at = data + i * sizeof pixel;
        std::memcpy(pixel, at, sizeof pixel);
        int scale = pixel[3];
        for (const int shift : {1, 2, 4, 8})
            scale |= scale >> shift;
        const int y = pixel[0], co = static_cast<Signed>(pixel[1]), cg = static_cast<Signed>(pixel[2]);
        const int alpha = ((pixel[3] << 1) & scale) | (pixel[3] & 1);
        const int source[] = {y + co - cg, y + cg, y - co - cg, alpha};
        for (int c = 0; c < 4; ++c) {
            const double value = scale == 0 ? 0 : static_cast<double>(source[c]) * largest / scale + 0.5;
            pixel[c] = static_cast<T>(std::clamp(value, 0.0, static_cast<double>(largest)));
        }
        std::memcpy(at, pixel, sizeof pixel);
    }
}

void applyFilter(const Stream& stream, unsigned char* data) {
    if (stream.filter == "OCTAHEDRAL") meshopt_decodeFilterOct(data, stream.count, stream.stride);
    if (stream.filter == "QUATERNION") meshopt_decodeFilterQuat(data, stream.count, stream.stride);
    if (stream.filter == "EXPONENTIAL") meshopt_decodeFilterExp(data, stream.count, stream.stride);
    if (stream.filter == "COLOR" && stream.stride == 4)
        decodeColors<std::uint8_t, std::int8_t>(data, stream.count);
    if (stream.filter == "COLOR" && stream.stride == 8)
        decodeColors<std::uint16_t, std::int16_t>(data, stream.count);
}

void decodeView(GltfFile& file, std::size_t index, const std::string& place, const tinygltf::Value& object) {
    const Stream stream = readStream(file, place, object);
    checkStream(file, stream);
    file.claimDecompressed(place, stream.count * stream.stride);
    std::vector<unsigned char> data(stream.count * stream.stride);
    if (stream.count > 0) {
        if (!decode(stream, data.data()))
            file.fail(place, fmt::format("a stream of version 0 with {} elements", stream.count),
                      fmt::format("{} bytes that are none", stream.bytes.size()));
        applyFilter(stream, data.data());
    }
    tinygltf::BufferView& view = file.model.bufferViews[index];
    view.buffer = static_cast<int>(file.model.buffers.size());
    view.byteOffset = 0;
    view.byteLength = data.size();
    file.model.buffers.emplace_back().data = std::move(data);
}

} // namespace

void decodeMeshopt(GltfFile& file) {
    for (std::size_t i = 0; i < file.model.bufferViews.size(); ++i)
        for (const char* name : {"EXT_meshopt_compression", "KHR_meshopt_compression"}) {
            const tinygltf::Value* object = extensionObject(file.model.bufferViews[i].extensions, name);
            if (!object) continue;
            decodeView(file, i, fmt::format("bufferViews[{}].{}", i, name), *object);
            break;
        }
}

} // namespace limpid::io
