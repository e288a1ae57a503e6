#pragma once
#include <filesystem>

#include <toml++/toml.h>

#include "scene/Model.h"

namespace limpid::io {

/// The scene that a model gets when it is given alone: the model on a floor under water, waves and a sun, all
/// in proportion to its bounds. Its own lights stand for the sun if any of them gets into the water, and its
/// first camera for ours if that sees the model. A table, so that `--set` reaches every entry of it.
toml::table defaultScene(const std::filesystem::path& file, const Model& model);

} // namespace limpid::io
