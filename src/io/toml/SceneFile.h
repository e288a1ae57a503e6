#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "scene/Scene.h"

namespace limpid::io {

/// What the command line changes about a scene: `--set KEY=VALUE` in order; `--method`, `--planes` and
/// `--map-size` arrive here as `caustics.…` keys.
struct Override {
    std::string key;   ///< dotted path; named entries by name, others by number: `light.sun.direction`
    std::string value; ///< a TOML value; a bare word counts as a string
};

/// A model's name, whose suffix may be in capitals.
bool isModelFile(const std::filesystem::path& file);

/// Leaves out of a model that is given alone what `patterns` name (`--without`; key `without` of its
/// receiver).
Override leavingOut(const std::vector<std::string>& patterns);

/// Loads a scene file (.toml) or a model (.glb, .gltf), applies the overrides, checks every value.
/// A model alone gets a floor, waves and a sun chosen from its bounds. What is left to the engine
/// (camera position, water extent) stays empty.
/// Throws InputError: file, place (line:column or key), expected, found.
Scene loadScene(const std::filesystem::path& file, const std::vector<Override>& overrides = {});

} // namespace limpid::io
