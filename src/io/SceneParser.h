#pragma once
#include <filesystem>
#include <map>
#include <memory>

#include <toml++/toml.h>

#include "scene/Scene.h"

namespace limpid::io {

/// Models by absolute path, so that receivers of the same file share one mesh.
using MeshCache = std::map<std::filesystem::path, std::shared_ptr<const Mesh>>;

/// Turns the table of a scene file into a checked scene. `file` is named in errors, relative paths start at
/// its folder. Throws InputError.
Scene parseScene(const toml::table& root, const std::filesystem::path& file, MeshCache& meshes);

/// Whether `name` can be part of a file's name: 1 to 100 letters, digits, `_`, `-` and `.`, no dot in front.
bool isName(const std::string& name);

} // namespace limpid::io
