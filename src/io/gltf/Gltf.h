#pragma once
#include <filesystem>

#include "io/NamePatterns.h"
#include "scene/Model.h"

namespace limpid::io {

/// Loads the default scene of a .glb or .gltf file: its triangles as one mesh in the pose that they have at
/// rest, node transforms applied, metres, Y up; its lights (see `readLights` for their units) and perspective
/// cameras. Left out: hidden nodes, and what `without` names: nodes, by their own name or their mesh's, with
/// all below them; triangles, by their material's name. What is not used has a notice in the mesh, and so has
/// a pattern that stands for nothing in the file. Throws InputError (file, place, expected, found) for a file
/// that cannot be read or breaks the format.
Model loadModel(const std::filesystem::path& file, const NamePatterns& without = {});

/// The mesh alone, with notices of the lights and cameras that stay behind.
Mesh loadGltf(const std::filesystem::path& file, const NamePatterns& without = {});

} // namespace limpid::io
