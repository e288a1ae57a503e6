#include "io/gltf/File.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include "core/Error.h"
#include "io/Files.h"
#include "io/gltf/Compressed.h"
#include "io/gltf/Draco.h"
#include "io/gltf/Extensions.h"
#include "io/gltf/Meshopt.h"
#include "io/gltf/Uris.h"

namespace fs = std::filesystem;

namespace limpid::io {

namespace {

/// tinygltf walks `extras` and `extensions` by recursion; this many levels fit on any stack.
constexpr int maxJsonDepth = 200;
/// Of decompressed to compressed bytes. Both codecs reach it with data that hardly changes, and no more.
constexpr std::size_t maxExpansion = 256;
constexpr std::size_t glbHeaderSize = 12;
constexpr std::size_t chunkHeaderSize = 8;

/// What tinygltf's file callbacks know.
struct FolderAccess {
    fs::path folder;
    std::string refused; ///< the last reference that leads out of the folder
};

bool hasScheme(std::string_view uri) {
    const std::size_t colon = uri.find(':');
    return colon != std::string_view::npos && uri.substr(0, colon).find('/') == std::string_view::npos;
}

/// Whether `uri` is a relative path that stays where it starts.
bool staysInside(std::string uri) {
    std::replace(uri.begin(), uri.end(), '\\', '/');
    const fs::path path(uri);
    return !uri.empty() && path.is_relative() && !hasScheme(uri) && uri.find('\0') == std::string::npos &&
           std::find(path.begin(), path.end(), "..") == path.end();
}

bool fileExists(const std::string& uri, void* userData) {
    auto& access = *static_cast<FolderAccess*>(userData);
    if (!staysInside(uri)) {
        // tinygltf asks a second time with ./ in front.
        if (!uri.starts_with("./")) access.refused = uri;
        return false;
    }
    std::error_code ignored;
    return fs::is_regular_file(fileOfUri(access.folder, uri), ignored);
}

std::string keepPath(const std::string& uri, void*) {
    return uri;
}

bool readWholeFile(std::vector<unsigned char>* out, std::string* error, const std::string& uri,
                   void* userData) {
    try {
        *out = readBytes(fileOfUri(static_cast<FolderAccess*>(userData)->folder, uri));
        return true;
    } catch (const InputError& failure) {
        *error = failure.what();
        return false;
    }
}

bool writeNothing(std::string*, const std::string&, const std::vector<unsigned char>&, void*) {
    return false;
}

/// Keeps the encoded bytes. Those of a buffer view stay where they are: tinygltf has not checked its range.
bool keepEncoded(tinygltf::Image* image, const int, std::string*, std::string*, int, int,
                 const unsigned char* bytes, int size, void*) {
    if (image->bufferView < 0) image->image.assign(bytes, bytes + size);
    image->as_is = true;
    return true;
}

int jsonDepth(std::string_view json) {
    int depth = 0, deepest = 0;
    bool inString = false;
    for (std::size_t i = 0; i < json.size(); ++i) {
        const char c = json[i];
        if (inString && c == '\\')
            ++i;
        else if (c == '"')
            inString = !inString;
        else if (!inString && (c == '[' || c == '{'))
            deepest = std::max(deepest, ++depth);
        else if (!inString && (c == ']' || c == '}'))
            --depth;
    }
    return deepest;
}

std::uint32_t readU32(const std::vector<std::uint8_t>& bytes, std::size_t offset) {
    return bytes[offset] | bytes[offset + 1] << 8 | bytes[offset + 2] << 16 |
           static_cast<std::uint32_t>(bytes[offset + 3]) << 24;
}

bool isBinary(const std::vector<std::uint8_t>& bytes) {
    return bytes.size() >= 4 && std::memcmp(bytes.data(), "glTF", 4) == 0;
}

/// The JSON chunk of a GLB, after a check of the first two chunks: tinygltf forgets the second one's header
/// when it compares lengths, and would read 8 bytes too far.
std::string_view checkGlb(const GltfFile& file, const std::vector<std::uint8_t>& bytes) {
    const std::size_t jsonStart = glbHeaderSize + chunkHeaderSize;
    if (bytes.size() < jsonStart)
        file.fail("GLB header", fmt::format("at least {} bytes", jsonStart), fmt::format("{}", bytes.size()));
    if (readU32(bytes, 4) != 2) file.fail("GLB header", "version 2", fmt::format("{}", readU32(bytes, 4)));
    const std::size_t length = readU32(bytes, 8);
    if (length > bytes.size())
        file.fail("GLB header", fmt::format("a length of at most {}", bytes.size()),
                  fmt::format("{}", length));
    const std::size_t jsonLength = readU32(bytes, glbHeaderSize);
    if (length < jsonStart || jsonLength > length - jsonStart)
        file.fail("GLB JSON chunk", fmt::format("a chunk inside of {} bytes", length),
                  fmt::format("a length of {}", jsonLength));
    const std::size_t binary = jsonStart + jsonLength;
    if (binary + chunkHeaderSize <= length && readU32(bytes, binary) > length - binary - chunkHeaderSize)
        file.fail("GLB binary chunk", fmt::format("at most {} bytes", length - binary - chunkHeaderSize),
                  fmt::format("a length of {}", readU32(bytes, binary)));
    return {reinterpret_cast<const char*>(bytes.data()) + jsonStart, jsonLength};
}

void putU32(std::vector<std::uint8_t>& bytes, std::size_t offset, std::size_t value) {
    for (std::size_t i = 0; i < 4; ++i)
        bytes[offset + i] = static_cast<std::uint8_t>(value >> (8 * i));
}

/// Gives a checked GLB another JSON chunk.
void replaceJson(std::vector<std::uint8_t>& glb, std::string json) {
    json.resize((json.size() + 3) / 4 * 4, ' ');
    glb.resize(readU32(glb, 8));
    const auto start = glb.begin() + glbHeaderSize + chunkHeaderSize;
    const auto rest = glb.erase(start, start + readU32(glb, glbHeaderSize));
    glb.insert(rest, json.begin(), json.end());
    putU32(glb, 8, glb.size());
    putU32(glb, glbHeaderSize, json.size());
}

void checkVersion(const GltfFile& file) {
    const tinygltf::Asset& asset = file.model.asset;
    if (!asset.version.starts_with("2."))
        file.fail("asset.version", "2.0", fmt::format("\"{}\"", oneLine(asset.version, 40)));
    if (!asset.minVersion.empty() && asset.minVersion != "2.0")
        file.fail("asset.minVersion", "2.0", fmt::format("\"{}\"", oneLine(asset.minVersion, 40)));
}

std::string_view jsonOf(const GltfFile& file, const std::vector<std::uint8_t>& bytes) {
    return isBinary(bytes) ? checkGlb(file, bytes)
                           : std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size());
}

/// Checks the file as far as tinygltf needs it, and changes what of its JSON it would not take, or take
/// wrongly.
void prepare(const GltfFile& file, std::vector<std::uint8_t>& bytes) {
    if (const int depth = jsonDepth(jsonOf(file, bytes)); depth > maxJsonDepth)
        file.fail("JSON", fmt::format("at most {} nested levels", maxJsonDepth), fmt::format("{}", depth));
    for (const auto change : {withoutCompressionGaps, withEscapedUris})
        if (std::optional<std::string> changed = change(jsonOf(file, bytes))) {
            if (isBinary(bytes))
                replaceJson(bytes, std::move(*changed));
            else
                bytes.assign(changed->begin(), changed->end());
        }
    if (bytes.size() > std::numeric_limits<std::uint32_t>::max())
        file.fail("glTF", "a file below 4 GiB", fmt::format("{} bytes", bytes.size()));
}

void parse(GltfFile& file, const std::vector<std::uint8_t>& bytes, FolderAccess& access) {
    tinygltf::TinyGLTF loader;
    loader.SetImageLoader(keepEncoded, nullptr);
    loader.SetFsCallbacks({fileExists, keepPath, readWholeFile, writeNothing, &access});
    const auto size = static_cast<unsigned int>(bytes.size());
    std::string error, warning;
    bool good = false;
    try {
        good = isBinary(bytes)
                   ? loader.LoadBinaryFromMemory(&file.model, &error, &warning, bytes.data(), size)
                   : loader.LoadASCIIFromString(&file.model, &error, &warning,
                                                reinterpret_cast<const char*>(bytes.data()), size, "");
    } catch (const std::exception& failure) {
        error += failure.what();
    }
    // Before tinygltf's own error, which an unknown extension may be the cause of.
    checkRequiredExtensions(file);
    if (good) return;
    if (!access.refused.empty() && error.find("File not found") != std::string::npos)
        file.fail("buffers", "a file inside of the model's folder",
                  fmt::format("\"{}\"", oneLine(access.refused, 80)));
    file.fail("glTF", "a valid file", "an error: " + oneLine(error));
}

} // namespace

void GltfFile::fail(const std::string& place, const std::string& expected, const std::string& found) const {
    throw InputError(fmt::format("{}: {}: expected {}, found {}", name, place, expected, found));
}

void GltfFile::requireIndex(const std::string& place, int index, std::size_t count) const {
    if (index < 0 || static_cast<std::size_t>(index) >= count)
        fail(place,
             count == 0 ? "no index, as there is nothing to refer to"
                        : fmt::format("an index below {}", count),
             fmt::format("{}", index));
}

void GltfFile::claimDecompressed(const std::string& place, std::size_t bytes) {
    const std::size_t left = size * maxExpansion - decompressed;
    if (bytes > left)
        fail(place, fmt::format("at most {} bytes more once decompressed, for a file of {}", left, size),
             fmt::format("{}", bytes));
    decompressed += bytes;
}

int GltfFile::addBuffer(std::vector<unsigned char> data) {
    tinygltf::BufferView view;
    view.buffer = static_cast<int>(model.buffers.size());
    view.byteLength = data.size();
    model.buffers.emplace_back().data = std::move(data);
    model.bufferViews.push_back(std::move(view));
    return static_cast<int>(model.bufferViews.size()) - 1;
}

GltfFile readGltfFile(const fs::path& path) {
    GltfFile file;
    file.name = oneLine(path.string());
    std::vector<std::uint8_t> bytes = readBytes(path);
    FolderAccess access{path.parent_path(), {}};
    prepare(file, bytes);
    parse(file, bytes, access);
    checkVersion(file);
    file.size = bytes.size();
    for (const tinygltf::Buffer& buffer : file.model.buffers)
        file.size += buffer.data.size();
    decodeMeshopt(file);
    decodeDraco(file);
    return file;
}

} // namespace limpid::io
