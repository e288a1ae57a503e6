#pragma once
#include <vector>

#include <glm/glm.hpp>

#include "io/GltfFile.h"

namespace limpid::io {

/// A node that shows a mesh.
struct MeshInstance {
    int mesh = 0; ///< a valid index
    glm::dmat4 transform{1.0};
};

/// The meshes of the default scene, else of scene 0, else of all root nodes. Throws InputError if the nodes
/// are no trees or a transform is not finite.
std::vector<MeshInstance> sceneMeshes(const GltfFile& file);

} // namespace limpid::io
