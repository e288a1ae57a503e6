#pragma once
#include <vector>

#include <glm/glm.hpp>

#include "io/NamePatterns.h"
#include "io/gltf/File.h"

namespace limpid::io {

/// A node of the scene, where it is in the world.
struct SceneNode {
    std::size_t node = 0; ///< a valid index
    glm::dmat4 transform{1.0};
};

/// The nodes with a mesh, camera or light of the default scene, else of scene 0, else below all root nodes.
/// Nodes that are hidden (KHR_node_visibility) or that `without` names are left out with all below them.
/// Their meshes and cameras are valid indices. Throws InputError if the nodes are no trees or a transform is
/// not finite.
std::vector<SceneNode> sceneNodes(const GltfFile& file, const NamePatterns& without);

/// Of a node whose mesh is a valid index.
const std::string& meshName(const GltfFile& file, const tinygltf::Node& node);

/// Where every node of the file is, in a scene or not. `sceneNodes` must have been found good.
std::vector<glm::dmat4> nodeTransforms(const GltfFile& file);

/// Translation, then rotation by a quaternion x, y, z, w, then scale, as glTF puts them together. Throws
/// InputError for a quaternion without direction, which stands at `place`.
glm::dmat4 composeTransform(const GltfFile& file, const std::string& place, const glm::dvec3& translation,
                            const glm::dvec4& rotation, const glm::dvec3& scale);

} // namespace limpid::io
