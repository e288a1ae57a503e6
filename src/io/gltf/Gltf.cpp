#include "io/gltf/Gltf.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "io/Files.h"
#include "io/gltf/File.h"
#include "io/gltf/Materials.h"
#include "io/gltf/Nodes.h"
#include "io/gltf/Notices.h"
#include "io/gltf/Pose.h"
#include "io/gltf/Primitive.h"
#include "io/gltf/Views.h"
#include "scene/Places.h"

namespace limpid::io {

namespace {

/// Copies of meshes that a file may make: each takes a byte of it at least, wherever they are not all in one
/// place.
std::size_t roomForInstances(const GltfFile& file) {
    return std::min(std::size_t(1) << 20, file.size + file.decompressed);
}

/// A file on its way into a mesh.
struct Loading {
    const GltfFile& file;
    const NamePatterns& without;
    Skins skins;
    std::size_t room; ///< for so many copies of meshes more
};

bool isLeftOut(const Loading& loading, const tinygltf::Primitive& primitive) {
    const auto& materials = loading.file.model.materials;
    const auto index = static_cast<std::size_t>(primitive.material); // -1 is beyond all
    return index < materials.size() && loading.without.match(materials[index].name);
}

/// The mesh of a node, and every copy of it.
void addMesh(Loading& loading, const SceneNode& place, Mesh& mesh) {
    const GltfFile& file = loading.file;
    const tinygltf::Node& node = file.model.nodes[place.node];
    const Joints* joints =
        node.skin == -1 ? nullptr : &loading.skins.joints(fmt::format("nodes[{}]", place.node), node.skin);
    const std::vector<double> weights = morphWeights(file, place.node);
    std::vector<glm::dmat4> transforms = instanceTransforms(file, place.node, loading.room);
    if (transforms.size() > 1) loading.room -= transforms.size();
    for (glm::dmat4& transform : transforms)
        transform = place.transform * transform;
    const std::size_t first = mesh.positions.size();
    const auto& primitives = file.model.meshes[static_cast<std::size_t>(node.mesh)].primitives;
    for (std::size_t i = 0; i < primitives.size(); ++i)
        if (!isLeftOut(loading, primitives[i]))
            addPrimitive({file, fmt::format("meshes[{}].primitives[{}]", node.mesh, i), primitives[i],
                          weights, transforms, joints},
                         mesh);
    mesh.nodes.push_back({node.name, meshName(file, node), static_cast<std::uint32_t>(first),
                          static_cast<std::uint32_t>(mesh.positions.size() - first)});
}

/// Notices for patterns that stand for nothing in the file.
void noticeUnmatched(const GltfFile& file, const NamePatterns& without, Mesh& mesh) {
    std::set<std::string> names;
    for (const tinygltf::Node& node : file.model.nodes)
        names.insert(node.name);
    for (const tinygltf::Mesh& each : file.model.meshes)
        names.insert(each.name);
    for (const tinygltf::Material& material : file.model.materials)
        names.insert(material.name);
    names.erase("");
    for (const std::string& pattern : without.patterns())
        if (std::none_of(names.begin(), names.end(),
                         [&](const std::string& name) { return NamePatterns({pattern}).match(name); }))
            addNotice(file, mesh, "without",
                      fmt::format("expected the name of a node, mesh or material ({}), found \"{}\"",
                                  names.empty() ? "there are none"
                                                : oneLine(fmt::format("{}", fmt::join(names, ", "))),
                                  oneLine(pattern)));
}

/// A model with the nodes that it is of.
struct LoadedModel {
    Model model;
    GltfFile file;
    std::vector<SceneNode> nodes;
};

LoadedModel load(const std::filesystem::path& path, const NamePatterns& without) {
    LoadedModel loaded{{}, readGltfFile(path), {}};
    const GltfFile& file = loaded.file;
    Mesh& mesh = loaded.model.mesh;
    loaded.nodes = sceneNodes(file, without);
    Loading loading{file, without, Skins(file), roomForInstances(file)};
    for (const SceneNode& node : loaded.nodes)
        if (file.model.nodes[node.node].mesh != -1) addMesh(loading, node, mesh);
    if (mesh.indices.empty())
        file.fail("scene", "a mesh with triangles",
                  without.empty() ? "no triangles" : "no triangles but those left out");
    addMaterials(file, mesh);
    noticeUnmatched(file, without, mesh);
    noticeUnused(file, loaded.nodes, mesh);
    dropRepeatedTriangles(mesh);
    return loaded;
}

} // namespace

Model loadModel(const std::filesystem::path& path, const NamePatterns& without) {
    LoadedModel loaded = load(path, without);
    Model& model = loaded.model;
    Bounds bounds;
    for (const glm::dvec3& p : model.mesh.positions)
        bounds.add(p);
    model.lights = readLights(loaded.file, loaded.nodes, bounds.center());
    model.cameras = readCameras(loaded.file, loaded.nodes, bounds.center());
    return std::move(model);
}

Mesh loadGltf(const std::filesystem::path& path, const NamePatterns& without) {
    LoadedModel loaded = load(path, without);
    noticeUnusedViews(loaded.file, loaded.nodes, loaded.model.mesh);
    return std::move(loaded.model.mesh);
}

} // namespace limpid::io
