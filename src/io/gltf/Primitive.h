#pragma once
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "io/gltf/File.h"
#include "io/gltf/Pose.h"
#include "scene/Mesh.h"

namespace limpid::io {

/// A primitive of a mesh, as a node shows it.
struct PrimitiveTask {
    const GltfFile& file;
    std::string place;
    const tinygltf::Primitive& primitive;
    const std::vector<double>& morphWeights;
    const std::vector<glm::dmat4>& transforms; ///< to the world, one for each copy
    const Joints* joints = nullptr;            ///< the node's skin, which stands for `transforms`
};

/// Adds a primitive's triangles to the mesh, in the pose that the file has at rest: positions, normals (from
/// the faces where the file has none), texture coordinates, colours, and the part with its material. Nothing
/// for points and lines. Throws InputError.
void addPrimitive(const PrimitiveTask& task, Mesh& mesh);

} // namespace limpid::io
