#pragma once
#include <filesystem>
#include <map>
#include <memory>
#include <tuple>

#include <toml++/toml.h>

#include "io/NamePatterns.h"
#include "scene/Scene.h"

namespace limpid::io {

class TomlTable;

/// A model by its absolute path and what is left out of it.
struct MeshKey {
    std::filesystem::path file;
    NamePatterns without;

    bool operator<(const MeshKey& other) const {
        return std::tie(file, without) < std::tie(other.file, other.without);
    }
};

/// Receivers of the same model share one mesh.
using MeshCache = std::map<MeshKey, std::shared_ptr<const Mesh>>;

/// Turns the table of a scene file into a checked scene. `file` is named in errors, relative paths start at
/// its folder. Throws InputError.
Scene parseScene(const toml::table& root, const std::filesystem::path& file, MeshCache& meshes);

/// The key `without` of a receiver. Throws InputError.
NamePatterns parseWithout(TomlTable& receiver);

/// Whether `name` can be part of a file's name: 1 to 100 letters, digits, `_`, `-` and `.`, no dot in front.
bool isName(const std::string& name);

} // namespace limpid::io
