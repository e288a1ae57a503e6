#include "GlbWriter.h"

#include <glm/common.hpp>
#include <nlohmann/json.hpp>

#include <bit>
#include <cmath>
#include <fstream>
#include <stdexcept>

namespace limpid::models {

namespace {

using nlohmann::ordered_json;

static_assert(std::endian::native == std::endian::little, "glTF is little-endian");

// Numbers of the glTF 2.0 specification, section 5 (properties) and 4.4 (binary container).
constexpr int componentUnsignedShort = 5123;
constexpr int componentFloat = 5126;
constexpr int targetVertices = 34962;
constexpr int targetIndices = 34963;
constexpr std::uint32_t magic = 0x46546C67;
constexpr std::uint32_t chunkJson = 0x4E4F534A;
constexpr std::uint32_t chunkBinary = 0x004E4942;

/// The binary chunk and the views and accessors that describe it, filled side by side.
struct Content {
    std::string bytes;
    ordered_json views = ordered_json::array();
    ordered_json accessors = ordered_json::array();
};

template <typename T>
void append(std::string& bytes, const T& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

void padTo4(std::string& bytes, char filler) {
    bytes.resize((bytes.size() + 3) / 4 * 4, filler);
}

ordered_json numbers(const glm::vec3& v) {
    return {v.x, v.y, v.z};
}

void closeView(Content& content, std::size_t begin, int target) {
    content.views.push_back({{"buffer", 0},
                             {"byteOffset", begin},
                             {"byteLength", content.bytes.size() - begin},
                             {"target", target}});
    padTo4(content.bytes, '\0');
}

void addIndices(Content& content, const std::vector<std::uint32_t>& indices) {
    const std::size_t begin = content.bytes.size();
    for (std::uint32_t index : indices)
        append(content.bytes, static_cast<std::uint16_t>(index));
    content.accessors.push_back({{"bufferView", content.views.size()},
                                 {"componentType", componentUnsignedShort},
                                 {"count", indices.size()},
                                 {"type", "SCALAR"}});
    closeView(content, begin, targetIndices);
}

void addVectors(Content& content, const std::vector<glm::dvec3>& vectors) {
    const std::size_t begin = content.bytes.size();
    glm::vec3 min{vectors.front()};
    glm::vec3 max{vectors.front()};
    for (const glm::dvec3& vector : vectors) {
        const glm::vec3 single{vector};
        append(content.bytes, single);
        min = glm::min(min, single);
        max = glm::max(max, single);
    }
    content.accessors.push_back({{"bufferView", content.views.size()},
                                 {"componentType", componentFloat},
                                 {"count", vectors.size()},
                                 {"type", "VEC3"},
                                 {"min", numbers(min)},
                                 {"max", numbers(max)}});
    closeView(content, begin, targetVertices);
}

// Four components: glTF wants each vertex to begin at a multiple of four bytes.
void addColours(Content& content, const std::vector<glm::dvec3>& colours) {
    if (colours.empty()) return;
    const std::size_t begin = content.bytes.size();
    for (const glm::dvec3& colour : colours) {
        for (int c = 0; c < 3; ++c)
            append(content.bytes, static_cast<std::uint16_t>(std::lround(colour[c] * 65535.0)));
        append(content.bytes, std::uint16_t{65535});
    }
    content.accessors.push_back({{"bufferView", content.views.size()},
                                 {"componentType", componentUnsignedShort},
                                 {"normalized", true},
                                 {"count", colours.size()},
                                 {"type", "VEC4"}});
    closeView(content, begin, targetVertices);
}

ordered_json materialJson(const std::string& name, const Material& material) {
    const glm::vec3 c = material.colour;
    return {{"name", name},
            {"pbrMetallicRoughness",
             {{"baseColorFactor", {c.r, c.g, c.b, 1.0f}},
              {"metallicFactor", 0.0f},
              {"roughnessFactor", material.roughness}}}};
}

ordered_json document(const std::string& name, const Material& material, const Content& content) {
    ordered_json attributes = {{"POSITION", 1}, {"NORMAL", 2}};
    if (content.accessors.size() > 3) attributes["COLOR_0"] = 3;
    const ordered_json primitive = {{"attributes", attributes}, {"indices", 0}, {"material", 0}};
    return {{"asset", {{"version", "2.0"}, {"generator", "limpid-make-models"}}},
            {"scene", 0},
            {"scenes", {{{"nodes", {0}}}}},
            {"nodes", {{{"name", name}, {"mesh", 0}}}},
            {"meshes", {{{"name", name}, {"primitives", {primitive}}}}},
            {"materials", {materialJson(name, material)}},
            {"accessors", content.accessors},
            {"bufferViews", content.views},
            {"buffers", {{{"byteLength", content.bytes.size()}}}}};
}

void appendChunk(std::string& bytes, std::uint32_t type, const std::string& chunk) {
    append(bytes, static_cast<std::uint32_t>(chunk.size()));
    append(bytes, type);
    bytes += chunk;
}

} // namespace

void writeGlb(const std::filesystem::path& path, const std::string& name, const Mesh& mesh,
              const Material& material) {
    if (mesh.positions.empty() || mesh.positions.size() > 65535)
        throw std::runtime_error(path.string() + ": expected 1 to 65535 vertices, got " +
                                 std::to_string(mesh.positions.size()));
    Content content;
    addIndices(content, mesh.indices);
    addVectors(content, mesh.positions);
    addVectors(content, mesh.normals);
    addColours(content, mesh.colours);
    std::string json = document(name, material, content).dump();
    padTo4(json, ' ');

    std::string chunks;
    appendChunk(chunks, chunkJson, json);
    appendChunk(chunks, chunkBinary, content.bytes);
    constexpr std::uint32_t headerSize = 12;
    std::string file;
    append(file, magic);
    append(file, std::uint32_t{2});
    append(file, static_cast<std::uint32_t>(headerSize + chunks.size()));
    file += chunks;

    std::ofstream stream{path, std::ios::binary};
    stream.write(file.data(), static_cast<std::streamsize>(file.size()));
    stream.close();
    if (!stream) throw std::runtime_error(path.string() + ": cannot write");
}

} // namespace limpid::models
