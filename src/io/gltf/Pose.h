#pragma once
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <glm/glm.hpp>

#include "io/gltf/Accessor.h"
#include "io/gltf/File.h"

namespace limpid::io {

/// The matrices of a skin's joints: where each is in the scene, times its inverse bind matrix.
using Joints = std::vector<glm::dmat4>;

/// The joints of the file's skins, made when they are asked for, and once.
class Skins {
  public:
    explicit Skins(const GltfFile& file) : _file(file) {}

    /// `place`: the node that refers to `skin`. Throws InputError.
    const Joints& joints(const std::string& place, int skin);

  private:
    const GltfFile& _file;
    std::vector<glm::dmat4> _nodes;
    std::map<int, Joints> _joints;
};

/// The copies that EXT_mesh_gpu_instancing makes of a node's mesh, in the node's own space; one where the
/// node is if it does not use it. Throws InputError, also for more than
/// `room` of them.
std::vector<glm::dmat4> instanceTransforms(const GltfFile& file, std::size_t node, std::size_t room);

/// The weights of a node's morph targets at rest: the node's, else its mesh's, else none. Throws InputError.
std::vector<double> morphWeights(const GltfFile& file, std::size_t node);

/// An attribute with the morph targets that have a weight.
class MorphedAttribute {
  public:
    explicit MorphedAttribute(AccessorView base) : _base(std::move(base)) {}
    void add(AccessorView target, double weight) { _targets.emplace_back(std::move(target), weight); }

    std::size_t count() const { return _base.count(); }
    int components() const { return _base.components(); }
    /// Component `c` of element `i`; a target that has fewer of them changes nothing in the others.
    double component(std::size_t i, int c) const;
    /// The first three of them.
    glm::dvec3 read(std::size_t i) const { return {component(i, 0), component(i, 1), component(i, 2)}; }

  private:
    AccessorView _base;
    std::vector<std::pair<AccessorView, double>> _targets;
};

/// JOINTS_n and WEIGHTS_n of a primitive: by which joints its vertices go, and how much by each.
class SkinnedVertices {
  public:
    /// `joints` must outlive this. Throws InputError.
    SkinnedVertices(const GltfFile& file, const std::string& place, const tinygltf::Primitive& primitive,
                    std::size_t count, const Joints& joints);

    /// Without any joints a primitive follows its node, whatever skin that has.
    bool empty() const { return _sets.empty(); }

    /// Throws InputError for a joint that the skin does not have.
    glm::dmat4 matrix(std::size_t vertex) const;

  private:
    struct Set {
        AccessorView joints, weights;
    };
    const glm::dmat4& joint(const Set& set, std::size_t vertex, int c) const;

    const GltfFile& _file;
    std::string _place;
    std::vector<Set> _sets;
    const Joints& _joints;
};

} // namespace limpid::io
