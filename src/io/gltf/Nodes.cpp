#include "io/gltf/Nodes.h"

#include <cmath>

#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

#include "io/gltf/Compressed.h"

namespace limpid::io {

namespace {

constexpr int noParent = -1;

std::string nodePlace(std::size_t node) {
    return fmt::format("nodes[{}]", node);
}

void requireNumbers(const GltfFile& file, const std::string& place, const std::vector<double>& numbers,
                    std::size_t count) {
    if (!numbers.empty() && numbers.size() != count)
        file.fail(place, fmt::format("{} numbers", count), fmt::format("{}", numbers.size()));
    for (const double number : numbers)
        if (!std::isfinite(number)) file.fail(place, "finite numbers", fmt::format("{}", number));
}

glm::dmat4 localTransform(const GltfFile& file, std::size_t index) {
    const tinygltf::Node& node = file.model.nodes[index];
    const std::string place = nodePlace(index);
    requireNumbers(file, place + ".matrix", node.matrix, 16);
    requireNumbers(file, place + ".translation", node.translation, 3);
    requireNumbers(file, place + ".rotation", node.rotation, 4);
    requireNumbers(file, place + ".scale", node.scale, 3);
    if (!node.matrix.empty()) {
        glm::dmat4 transform;
        for (int i = 0; i < 16; ++i)
            transform[i / 4][i % 4] = node.matrix[static_cast<std::size_t>(i)];
        return transform;
    }
    const auto& t = node.translation;
    const auto& r = node.rotation;
    const auto& s = node.scale;
    return composeTransform(file, place, t.empty() ? glm::dvec3(0) : glm::dvec3(t[0], t[1], t[2]),
                            r.empty() ? glm::dvec4(0, 0, 0, 1) : glm::dvec4(r[0], r[1], r[2], r[3]),
                            s.empty() ? glm::dvec3(1) : glm::dvec3(s[0], s[1], s[2]));
}

/// Each node's parent; throws unless every node has at most one.
std::vector<int> findParents(const GltfFile& file) {
    const auto& nodes = file.model.nodes;
    std::vector<int> parents(nodes.size(), noParent);
    for (std::size_t i = 0; i < nodes.size(); ++i)
        for (std::size_t k = 0; k < nodes[i].children.size(); ++k) {
            const std::string place = fmt::format("{}.children[{}]", nodePlace(i), k);
            const int child = nodes[i].children[k];
            file.requireIndex(place, child, nodes.size());
            int& parent = parents[static_cast<std::size_t>(child)];
            if (parent != noParent)
                file.fail(place, "a node without another parent",
                          fmt::format("{}, a child of {}", nodePlace(static_cast<std::size_t>(child)),
                                      nodePlace(static_cast<std::size_t>(parent))));
            parent = static_cast<int>(i);
        }
    return parents;
}

/// With one parent each, nodes that no root reaches go round in circles.
void checkCycles(const GltfFile& file, const std::vector<int>& parents) {
    std::vector<std::size_t> pending;
    std::vector<bool> reached(parents.size(), false);
    for (std::size_t i = 0; i < parents.size(); ++i)
        if (parents[i] == noParent) pending.push_back(i);
    while (!pending.empty()) {
        const std::size_t node = pending.back();
        pending.pop_back();
        reached[node] = true;
        for (const int child : file.model.nodes[node].children)
            pending.push_back(static_cast<std::size_t>(child));
    }
    for (std::size_t i = 0; i < reached.size(); ++i)
        if (!reached[i])
            file.fail(nodePlace(i), "nodes without a cycle",
                      "a node that is its own ancestor, or a child of one");
}

std::vector<std::size_t> rootNodes(const GltfFile& file, const std::vector<int>& parents) {
    const tinygltf::Model& model = file.model;
    std::vector<std::size_t> roots;
    if (model.scenes.empty() && model.defaultScene < 0) {
        for (std::size_t i = 0; i < parents.size(); ++i)
            if (parents[i] == noParent) roots.push_back(i);
        return roots;
    }
    const int scene = model.defaultScene < 0 ? 0 : model.defaultScene;
    file.requireIndex("scene", scene, model.scenes.size());
    std::vector<bool> listed(parents.size(), false);
    const std::vector<int>& nodes = model.scenes[static_cast<std::size_t>(scene)].nodes;
    for (std::size_t k = 0; k < nodes.size(); ++k) {
        const std::string place = fmt::format("scenes[{}].nodes[{}]", scene, k);
        file.requireIndex(place, nodes[k], parents.size());
        const auto node = static_cast<std::size_t>(nodes[k]);
        if (parents[node] != noParent)
            file.fail(place, "a root node",
                      fmt::format("{}, a child of nodes[{}]", nodePlace(node), parents[node]));
        if (listed[node]) file.fail(place, "a node only once", nodePlace(node) + " again");
        listed[node] = true;
        roots.push_back(node);
    }
    return roots;
}

/// Calls `visit(node, transform)` for `roots` and all below them, in the file's order; below a node for which
/// it gives false, for none.
template <typename Visit>
void walk(const GltfFile& file, const std::vector<std::size_t>& roots, const Visit& visit) {
    struct Step {
        std::size_t node;
        glm::dmat4 parent;
    };
    std::vector<Step> pending; // not recursion: files nest nodes as deep as they like
    for (auto root = roots.rbegin(); root != roots.rend(); ++root)
        pending.push_back({*root, glm::dmat4(1.0)});
    while (!pending.empty()) {
        const Step step = pending.back();
        pending.pop_back();
        const glm::dmat4 transform = step.parent * localTransform(file, step.node);
        if (!visit(step.node, transform)) continue;
        const std::vector<int>& children = file.model.nodes[step.node].children;
        for (auto child = children.rbegin(); child != children.rend(); ++child)
            pending.push_back({static_cast<std::size_t>(*child), transform});
    }
}

bool isHidden(const tinygltf::Node& node) {
    const auto* object = extensionObject(node.extensions, "KHR_node_visibility");
    return object && object->Get("visible").IsBool() && !object->Get("visible").Get<bool>();
}

} // namespace

const std::string& meshName(const GltfFile& file, const tinygltf::Node& node) {
    return file.model.meshes[static_cast<std::size_t>(node.mesh)].name;
}

glm::dmat4 composeTransform(const GltfFile& file, const std::string& place, const glm::dvec3& translation,
                            const glm::dvec4& rotation, const glm::dvec3& scale) {
    const double length = glm::length(rotation);
    if (!(length > 0) || !std::isfinite(length))
        file.fail(place + ".rotation", "a quaternion of length 1", fmt::format("length {}", length));
    const glm::dvec4 unit = rotation / length;
    return glm::translate(glm::dmat4(1.0), translation) *
           glm::mat4_cast(glm::dquat(unit.w, unit.x, unit.y, unit.z)) * glm::scale(glm::dmat4(1.0), scale);
}

std::vector<SceneNode> sceneNodes(const GltfFile& file, const NamePatterns& without) {
    const std::vector<int> parents = findParents(file);
    checkCycles(file, parents);
    std::vector<SceneNode> found;
    walk(file, rootNodes(file, parents), [&](std::size_t index, const glm::dmat4& transform) {
        const tinygltf::Node& node = file.model.nodes[index];
        if (isHidden(node)) return false;
        if (node.mesh != -1)
            file.requireIndex(nodePlace(index) + ".mesh", node.mesh, file.model.meshes.size());
        if (node.camera != -1)
            file.requireIndex(nodePlace(index) + ".camera", node.camera, file.model.cameras.size());
        if (without.match(node.name) || (node.mesh != -1 && without.match(meshName(file, node))))
            return false;
        if (node.mesh != -1 || node.camera != -1 || node.extensions.contains("KHR_lights_punctual"))
            found.push_back({index, transform});
        return true;
    });
    return found;
}

std::vector<glm::dmat4> nodeTransforms(const GltfFile& file) {
    const std::vector<int> parents = findParents(file);
    std::vector<std::size_t> roots;
    for (std::size_t i = 0; i < parents.size(); ++i)
        if (parents[i] == noParent) roots.push_back(i);
    std::vector<glm::dmat4> transforms(parents.size());
    walk(file, roots, [&](std::size_t index, const glm::dmat4& transform) {
        transforms[index] = transform;
        return true;
    });
    return transforms;
}

} // namespace limpid::io
