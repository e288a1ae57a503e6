#include "io/gltf/Pose.h"

#include <cmath>

#include <fmt/format.h>

#include "io/gltf/Attributes.h"
#include "io/gltf/Compressed.h"
#include "io/gltf/Nodes.h"

namespace limpid::io {

namespace {

constexpr int maxJointSets = 16; ///< of four joints each

/// A column-major matrix, whose components are floats.
glm::dmat4 readMatrix(const AccessorView& view, std::size_t i) {
    glm::dmat4 matrix;
    for (int c = 0; c < 16; ++c)
        matrix[c / 4][c % 4] = view.component(i, c);
    return matrix;
}

AccessorKind matrixKind() {
    return {{TINYGLTF_TYPE_MAT4}, {TINYGLTF_COMPONENT_TYPE_FLOAT}, "matrices of 4 by 4 floats"};
}

AccessorKind jointKind() {
    return {{TINYGLTF_TYPE_VEC4},
            {TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE, TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT},
            "vectors of 4 integers of 8 or 16 bits without sign"};
}

AccessorKind rotationKind() {
    return {{TINYGLTF_TYPE_VEC4},
            {TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_COMPONENT_TYPE_BYTE, TINYGLTF_COMPONENT_TYPE_SHORT},
            "vectors of 4 floats, or of 4 integers of 8 or 16 bits with sign"};
}

Joints makeJoints(const GltfFile& file, int index, const std::vector<glm::dmat4>& nodes) {
    const tinygltf::Skin& skin = file.model.skins[static_cast<std::size_t>(index)];
    const std::string place = fmt::format("skins[{}]", index);
    std::optional<AccessorView> inverses;
    if (skin.inverseBindMatrices != -1) {
        const std::string at = place + ".inverseBindMatrices";
        inverses.emplace(file, at, skin.inverseBindMatrices, matrixKind());
        if (inverses->count() < skin.joints.size())
            file.fail(at, fmt::format("{} matrices, one for each joint", skin.joints.size()),
                      fmt::format("{}", inverses->count()));
    }
    Joints joints;
    for (std::size_t k = 0; k < skin.joints.size(); ++k) {
        file.requireIndex(fmt::format("{}.joints[{}]", place, k), skin.joints[k], nodes.size());
        const glm::dmat4& node = nodes[static_cast<std::size_t>(skin.joints[k])];
        joints.push_back(inverses ? node * readMatrix(*inverses, k) : node);
    }
    if (joints.empty()) file.fail(place + ".joints", "at least one joint", "none");
    return joints;
}

/// An accessor of the instancing extension; all of a node's have one count.
std::optional<AccessorView> instanceView(const GltfFile& file, const std::string& place,
                                         const tinygltf::Value& attributes, const char* name,
                                         const AccessorKind& kind, std::size_t room,
                                         std::optional<std::size_t>& count) {
    const int accessor = indexMember(file, place, attributes, name);
    if (accessor == -1) return std::nullopt;
    const std::string at = place + "." + name;
    AccessorView view(file, at, accessor, kind);
    if (view.count() > room)
        file.fail(at, fmt::format("at most {} instances", room), fmt::format("{}", view.count()));
    if (count && view.count() != *count)
        file.fail(at, fmt::format("{} instances, as the others have", *count),
                  fmt::format("{}", view.count()));
    count = view.count();
    return view;
}

} // namespace

const Joints& Skins::joints(const std::string& place, int skin) {
    _file.requireIndex(place + ".skin", skin, _file.model.skins.size());
    if (_nodes.empty()) _nodes = nodeTransforms(_file);
    const auto found = _joints.find(skin);
    return found != _joints.end() ? found->second
                                  : _joints.emplace(skin, makeJoints(_file, skin, _nodes)).first->second;
}

std::vector<glm::dmat4> instanceTransforms(const GltfFile& file, std::size_t node, std::size_t room) {
    constexpr char extension[] = "EXT_mesh_gpu_instancing";
    const auto* object = extensionObject(file.model.nodes[node].extensions, extension);
    if (!object || !object->Get("attributes").IsObject()) return {glm::dmat4(1.0)};
    const tinygltf::Value& attributes = object->Get("attributes");
    const std::string place = fmt::format("nodes[{}].{}.attributes", node, extension);
    std::optional<std::size_t> count;
    const auto translations = instanceView(file, place, attributes, "TRANSLATION", vectorKind(), room, count);
    const auto rotations = instanceView(file, place, attributes, "ROTATION", rotationKind(), room, count);
    const auto scales = instanceView(file, place, attributes, "SCALE", vectorKind(), room, count);
    if (!count) return {glm::dmat4(1.0)}; // attributes of its own only, which say nothing of where
    std::vector<glm::dmat4> transforms;
    transforms.reserve(*count);
    for (std::size_t i = 0; i < *count; ++i)
        transforms.push_back(composeTransform(
            // A rotation alone can be wrong, and a million names take their time.
            file, rotations ? fmt::format("{}[{}]", place, i) : place,
            translations ? translations->vec3(i) : glm::dvec3(0),
            rotations ? glm::dvec4(rotations->vec3(i), rotations->component(i, 3)) : glm::dvec4(0, 0, 0, 1),
            scales ? scales->vec3(i) : glm::dvec3(1)));
    return transforms;
}

std::vector<double> morphWeights(const GltfFile& file, std::size_t index) {
    const tinygltf::Node& node = file.model.nodes[index];
    const bool own = !node.weights.empty();
    const std::vector<double>& weights =
        own ? node.weights : file.model.meshes[static_cast<std::size_t>(node.mesh)].weights;
    for (const double weight : weights)
        if (!std::isfinite(weight))
            file.fail(own ? fmt::format("nodes[{}].weights", index)
                          : fmt::format("meshes[{}].weights", node.mesh),
                      "finite numbers", fmt::format("{}", weight));
    return weights;
}

double MorphedAttribute::component(std::size_t i, int c) const {
    double value = _base.component(i, c);
    for (const auto& [target, weight] : _targets)
        if (c < target.components()) value += weight * target.component(i, c);
    return value;
}

SkinnedVertices::SkinnedVertices(const GltfFile& file, const std::string& place,
                                 const tinygltf::Primitive& primitive, std::size_t count,
                                 const Joints& joints)
    : _file(file), _place(place), _joints(joints) {
    for (int n = 0; n < maxJointSets; ++n) {
        auto indices =
            findAttribute(file, place, primitive.attributes, fmt::format("JOINTS_{}", n), jointKind(), count);
        auto weights = findAttribute(file, place, primitive.attributes, fmt::format("WEIGHTS_{}", n),
                                     weightKind(), count);
        if (!indices || !weights) break;
        _sets.push_back({std::move(*indices), std::move(*weights)});
    }
}

const glm::dmat4& SkinnedVertices::joint(const Set& set, std::size_t vertex, int c) const {
    const auto index = static_cast<std::size_t>(set.joints.component(vertex, c));
    if (index >= _joints.size())
        _file.fail(fmt::format("{}.attributes.JOINTS_{}[{}]", _place, &set - _sets.data(), vertex),
                   fmt::format("joints below {}", _joints.size()), fmt::format("{}", index));
    return _joints[index];
}

glm::dmat4 SkinnedVertices::matrix(std::size_t vertex) const {
    glm::dmat4 sum(0.0);
    double total = 0;
    for (const Set& set : _sets)
        for (int c = 0; c < 4; ++c) {
            const double weight = set.weights.component(vertex, c);
            if (!(weight > 0) || !std::isfinite(weight)) continue;
            sum += weight * joint(set, vertex, c);
            total += weight;
        }
    if (total > 0) return sum / total; // weights of few bits seldom add up to 1
    return joint(_sets.front(), vertex, 0);
}

} // namespace limpid::io
