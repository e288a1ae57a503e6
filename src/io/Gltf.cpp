#include "io/Gltf.h"

#include <algorithm>

#include <fmt/format.h>

#include "io/GltfFile.h"
#include "io/GltfMaterials.h"
#include "io/GltfNodes.h"
#include "io/GltfPose.h"
#include "io/GltfPrimitive.h"
#include "io/GltfViews.h"
#include "scene/Places.h"

namespace limpid::io {

namespace {

/// Copies of meshes that a file may make: each takes a byte of it at least, wherever they are not all in one
/// place.
std::size_t roomForInstances(const GltfFile& file) {
    return std::min(std::size_t(1) << 20, file.size + file.decompressed);
}

/// The mesh of a node, and every copy of it. `room`: for so many copies more.
void addMesh(const GltfFile& file, const SceneNode& place, Skins& skins, std::size_t& room, Mesh& mesh) {
    const tinygltf::Node& node = file.model.nodes[place.node];
    const Joints* joints =
        node.skin == -1 ? nullptr : &skins.joints(fmt::format("nodes[{}]", place.node), node.skin);
    const std::vector<double> weights = morphWeights(file, place.node);
    std::vector<glm::dmat4> transforms = instanceTransforms(file, place.node, room);
    if (transforms.size() > 1) room -= transforms.size();
    for (glm::dmat4& transform : transforms)
        transform = place.transform * transform;
    const auto& primitives = file.model.meshes[static_cast<std::size_t>(node.mesh)].primitives;
    for (std::size_t i = 0; i < primitives.size(); ++i)
        addPrimitive({file, fmt::format("meshes[{}].primitives[{}]", node.mesh, i), primitives[i], weights,
                      transforms, joints},
                     mesh);
}

} // namespace

Model loadModel(const std::filesystem::path& path) {
    const GltfFile file = readGltfFile(path);
    const std::vector<SceneNode> nodes = sceneNodes(file);
    Model model;
    Skins skins(file);
    std::size_t room = roomForInstances(file);
    for (const SceneNode& node : nodes)
        if (file.model.nodes[node.node].mesh != -1) addMesh(file, node, skins, room, model.mesh);
    if (model.mesh.indices.empty()) file.fail("scene", "a mesh with triangles", "no triangles");
    addMaterials(file, model.mesh);
    dropRepeatedTriangles(model.mesh);
    Bounds bounds;
    for (const glm::dvec3& p : model.mesh.positions)
        bounds.add(p);
    model.lights = readLights(file, nodes, bounds.center());
    model.cameras = readCameras(file, nodes, bounds.center());
    return model;
}

Mesh loadGltf(const std::filesystem::path& path) {
    return loadModel(path).mesh;
}

} // namespace limpid::io
