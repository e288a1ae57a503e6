#include "io/GltfNodes.h"

#include <cmath>

#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

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
    glm::dmat4 transform(1.0);
    if (!node.matrix.empty()) {
        for (int i = 0; i < 16; ++i)
            transform[i / 4][i % 4] = node.matrix[static_cast<std::size_t>(i)];
        return transform;
    }
    if (const auto& t = node.translation; !t.empty())
        transform = glm::translate(transform, {t[0], t[1], t[2]});
    if (const auto& r = node.rotation; !r.empty()) {
        const glm::dquat rotation(r[3], r[0], r[1], r[2]);
        const double length = glm::length(rotation);
        if (!(length > 0) || !std::isfinite(length))
            file.fail(place + ".rotation", "a quaternion of length 1", fmt::format("length {}", length));
        transform *= glm::mat4_cast(rotation / length);
    }
    if (const auto& s = node.scale; !s.empty()) transform = glm::scale(transform, {s[0], s[1], s[2]});
    return transform;
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

} // namespace

std::vector<MeshInstance> sceneMeshes(const GltfFile& file) {
    struct Visit {
        std::size_t node;
        glm::dmat4 parent;
    };
    const std::vector<int> parents = findParents(file);
    checkCycles(file, parents);
    const std::vector<std::size_t> roots = rootNodes(file, parents);
    std::vector<Visit> pending; // not recursion: files nest nodes as deep as they like
    for (auto root = roots.rbegin(); root != roots.rend(); ++root)
        pending.push_back({*root, glm::dmat4(1.0)});
    std::vector<MeshInstance> instances;
    while (!pending.empty()) {
        const Visit visit = pending.back();
        pending.pop_back();
        const tinygltf::Node& node = file.model.nodes[visit.node];
        const glm::dmat4 transform = visit.parent * localTransform(file, visit.node);
        if (node.mesh != -1) {
            file.requireIndex(nodePlace(visit.node) + ".mesh", node.mesh, file.model.meshes.size());
            instances.push_back({node.mesh, transform});
        }
        for (auto child = node.children.rbegin(); child != node.children.rend(); ++child)
            pending.push_back({static_cast<std::size_t>(*child), transform});
    }
    return instances;
}

} // namespace limpid::io
