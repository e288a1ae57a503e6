#pragma once
#include <filesystem>

#include "scene/Mesh.h"

namespace limpid::io {

/// Loads the default scene of a .glb or .gltf file as one mesh, node transforms applied, metres, Y up.
/// Throws InputError (file, place, expected, found) for a file that cannot be read or breaks the format.
Mesh loadGltf(const std::filesystem::path& file);

} // namespace limpid::io
