#pragma once
#include <string>
#include <vector>

#include "io/gltf/File.h"
#include "io/gltf/Nodes.h"
#include "scene/Mesh.h"

namespace limpid::io {

/// Adds "FILE: PLACE: TEXT" to the mesh's notices, once.
void addNotice(const GltfFile& file, Mesh& mesh, const std::string& place, const std::string& text);

/// Adds a notice for each kind of thing that `nodes` show, or the file plays or requires for looks, and that
/// the mesh goes without: names and reason. `mesh` has its parts. Textures: see `addMaterials`.
void noticeUnused(const GltfFile& file, const std::vector<SceneNode>& nodes, Mesh& mesh);

/// The same for the file's lights and cameras, which a scene file has of its own.
void noticeUnusedViews(const GltfFile& file, const std::vector<SceneNode>& nodes, Mesh& mesh);

} // namespace limpid::io
