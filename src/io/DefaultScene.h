#pragma once
#include <filesystem>

#include <toml++/toml.h>

#include "scene/Mesh.h"

namespace limpid::io {

/// The scene that a model gets when it is given alone: the model on a floor under water, waves and a sun, all
/// in proportion to its bounds. A table, so that `--set` reaches every entry of it.
toml::table defaultScene(const std::filesystem::path& model, const Mesh& mesh);

} // namespace limpid::io
