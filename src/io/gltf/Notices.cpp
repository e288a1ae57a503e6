#include "io/gltf/Notices.h"

#include <algorithm>
#include <map>
#include <set>

#include <fmt/format.h>

#include "io/Files.h"
#include "io/gltf/Compressed.h"
#include "io/gltf/Extensions.h"
#include "io/gltf/Materials.h"

namespace limpid::io {

namespace {

constexpr std::size_t mostBytes = 800; ///< of a notice

/// Names of what is not used, by place and reason.
using Unused = std::map<std::pair<std::string, std::string>, std::set<std::string>>;

std::string named(const std::string& name, const char* kind, std::size_t index) {
    return name.empty() ? fmt::format("{} {}", kind, index) : fmt::format("\"{}\"", name);
}

void addTo(const GltfFile& file, const Unused& unused, Mesh& mesh) {
    for (const auto& [where, names] : unused)
        addNotice(file, mesh, where.first,
                  fmt::format("not used: {} ({})", oneLine(fmt::format("{}", fmt::join(names, ", "))),
                              where.second));
}

void addExtensions(const GltfFile& file, Unused& unused) {
    for (const std::string& extension : file.model.extensionsUsed)
        if (const std::string_view reason = unusedReason(extension); !reason.empty())
            unused[{"extensionsUsed", std::string(reason)}].insert(extension);
}

void addAnimations(const tinygltf::Model& model, Unused& unused) {
    for (std::size_t i = 0; i < model.animations.size(); ++i)
        unused[{"animations", "models stand as they are at rest"}].insert(
            named(model.animations[i].name, "animation", i));
}

void addScenes(const tinygltf::Model& model, Unused& unused) {
    const auto shown = static_cast<std::size_t>(std::max(model.defaultScene, 0));
    for (std::size_t i = 0; i < model.scenes.size(); ++i)
        if (i != shown)
            unused[{"scenes", "the file's default scene is shown"}].insert(
                named(model.scenes[i].name, "scene", i));
}

void addTextures(const GltfFile& file, const Mesh& mesh, Unused& unused) {
    for (const MeshPart& part : mesh.parts) {
        const auto index = static_cast<std::size_t>(part.material);
        if (index >= file.model.materials.size()) continue; // the format's default
        const tinygltf::Material& material = file.model.materials[index];
        std::set<std::string>& names = unused[{"materials", std::string(mattReason)}];
        if (material.pbrMetallicRoughness.metallicRoughnessTexture.index >= 0)
            names.insert("metallicRoughnessTexture");
        if (material.occlusionTexture.index >= 0) names.insert("occlusionTexture");
    }
    std::erase_if(unused, [](const auto& entry) { return entry.second.empty(); });
}

bool isSet(const std::string& attribute, std::string_view prefix) {
    return attribute.starts_with(prefix) && attribute != fmt::format("{}0", prefix);
}

void addPrimitive(const GltfFile& file, const tinygltf::Primitive& primitive, Unused& unused) {
    if (primitive.mode < TINYGLTF_MODE_TRIANGLES)
        unused[{"meshes", "only triangles are drawn"}].insert(
            primitive.mode == TINYGLTF_MODE_POINTS ? "points" : "lines");
    const TextureMappings mappings = textureMappings(file, primitive.material);
    for (const auto& [name, accessor] : primitive.attributes) {
        const bool drawn = name == fmt::format("TEXCOORD_{}", mappings.color.texCoord) ||
                           name == fmt::format("TEXCOORD_{}", mappings.normal.texCoord);
        if (isSet(name, "TEXCOORD_") && !drawn)
            unused[{"meshes", "no texture that is drawn lies on it"}].insert(name);
        if (isSet(name, "COLOR_")) unused[{"meshes", "only COLOR_0 is drawn"}].insert(name);
        if (name.starts_with('_')) unused[{"meshes", "it is the author's own"}].insert(name);
    }
}

} // namespace

void addNotice(const GltfFile& file, Mesh& mesh, const std::string& place, const std::string& text) {
    std::string line = oneLine(fmt::format("{}: {}: {}", file.name, place, text), mostBytes);
    if (std::find(mesh.notices.begin(), mesh.notices.end(), line) == mesh.notices.end())
        mesh.notices.push_back(std::move(line));
}

void noticeUnused(const GltfFile& file, const std::vector<SceneNode>& nodes, Mesh& mesh) {
    Unused unused;
    addExtensions(file, unused);
    addAnimations(file.model, unused);
    addScenes(file.model, unused);
    addTextures(file, mesh, unused);
    std::set<int> meshes;
    for (const SceneNode& node : nodes)
        meshes.insert(file.model.nodes[node.node].mesh);
    meshes.erase(-1);
    for (const int index : meshes)
        for (const tinygltf::Primitive& primitive : file.model.meshes[std::size_t(index)].primitives)
            addPrimitive(file, primitive, unused);
    addTo(file, unused, mesh);
}

void noticeUnusedViews(const GltfFile& file, const std::vector<SceneNode>& nodes, Mesh& mesh) {
    Unused unused;
    for (const SceneNode& place : nodes) {
        const tinygltf::Node& node = file.model.nodes[place.node];
        if (node.camera != -1)
            unused[{"cameras", "the scene's own camera stands for it"}].insert(
                named(node.name, "nodes", place.node));
        if (extensionObject(node.extensions, "KHR_lights_punctual"))
            unused[{"lights", "the scene's own lights stand for it"}].insert(
                named(node.name, "nodes", place.node));
    }
    addTo(file, unused, mesh);
}

} // namespace limpid::io
