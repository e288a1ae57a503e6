#pragma once
#include <filesystem>

#include "scene/Model.h"

namespace limpid::io {

/// Loads the default scene of a .glb or .gltf file: its triangles as one mesh in the pose that they have at
/// rest, node transforms applied, metres, Y up; its lights (see `readLights` for their units) and perspective
/// cameras.
/// Throws InputError (file, place, expected, found) for a file that cannot be read or breaks the format.
Model loadModel(const std::filesystem::path& file);

/// The mesh alone.
Mesh loadGltf(const std::filesystem::path& file);

} // namespace limpid::io
