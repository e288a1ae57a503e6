#include "io/gltf/Compressed.h"

#include <nlohmann/json.hpp>

namespace limpid::io {

namespace {

using nlohmann::json;

/// Member `key` of an object, null for whatever else.
json* member(json* parent, const char* key) {
    if (!parent || !parent->is_object()) return nullptr;
    const auto found = parent->find(key);
    return found == parent->end() ? nullptr : &*found;
}

bool isFallback(json& buffer) {
    json* extensions = member(&buffer, "extensions");
    for (const char* name : {"EXT_meshopt_compression", "KHR_meshopt_compression"})
        if (const json* fallback = member(member(extensions, name), "fallback"))
            return fallback->is_boolean() && fallback->get<bool>();
    return false;
}

bool fillFallbackBuffers(json& root) {
    json* buffers = member(&root, "buffers");
    if (!buffers || !buffers->is_array()) return false;
    bool changed = false;
    for (json& buffer : *buffers) {
        if (!isFallback(buffer) || buffer.contains("uri")) continue;
        buffer["uri"] = "data:application/octet-stream;base64,AA==";
        buffer["byteLength"] = 1;
        changed = true;
    }
    return changed;
}

bool dropIndices(json& primitive) {
    json* extension = member(member(&primitive, "extensions"), "KHR_draco_mesh_compression");
    return extension && extension->is_object() && primitive.erase("indices") > 0;
}

bool dropDracoIndices(json& root) {
    json* meshes = member(&root, "meshes");
    if (!meshes || !meshes->is_array()) return false;
    bool changed = false;
    for (json& mesh : *meshes)
        if (json* primitives = member(&mesh, "primitives"); primitives && primitives->is_array())
            for (json& primitive : *primitives)
                changed |= dropIndices(primitive);
    return changed;
}

/// Written as a double, so that it may have been any number; -1 if it is none that a size can be.
double wholeNumber(const tinygltf::Value& value) {
    if (!value.IsNumber()) return -1;
    const double number = value.GetNumberAsDouble();
    return number >= 0 && number <= 2147483647.0 && number == static_cast<double>(static_cast<int>(number))
               ? number
               : -1;
}

} // namespace

std::optional<std::string> withoutCompressionGaps(std::string_view text) {
    const bool meshopt = text.find("meshopt_compression") != std::string_view::npos;
    const bool draco = text.find("KHR_draco_mesh_compression") != std::string_view::npos;
    if (!meshopt && !draco) return std::nullopt; // as nearly every file: not parsed twice
    json root = json::parse(text, nullptr, false);
    bool changed = fillFallbackBuffers(root);
    changed |= dropDracoIndices(root);
    if (!changed) return std::nullopt;
    return root.dump(-1, ' ', false, json::error_handler_t::replace);
}

const tinygltf::Value* extensionObject(const tinygltf::ExtensionMap& extensions, const char* name) {
    const auto found = extensions.find(name);
    return found == extensions.end() || !found->second.IsObject() ? nullptr : &found->second;
}

std::size_t sizeMember(const GltfFile& file, const std::string& place, const tinygltf::Value& object,
                       const char* key, bool required) {
    if (!required && !object.Has(key)) return 0;
    const double number = wholeNumber(object.Get(key));
    if (number < 0) file.fail(place + "." + key, "a whole number >= 0", "something else");
    return static_cast<std::size_t>(number);
}

int indexMember(const GltfFile& file, const std::string& place, const tinygltf::Value& object,
                const char* key) {
    return object.Has(key) ? static_cast<int>(sizeMember(file, place, object, key, true)) : -1;
}

} // namespace limpid::io
