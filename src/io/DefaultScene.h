#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include <toml++/toml.h>

#include "scene/Model.h"

namespace limpid::io {

/// The scene that a model gets when it is given alone: the model on a floor under water, waves and a sun, all
/// in proportion to its bounds. Its own lights stand for the sun if any of them gets into the water, and its
/// first camera for ours if that sees the model. A table, so that `--set` reaches every entry of it.
toml::table defaultScene(const std::filesystem::path& file, const Model& model);

/// Notices of the model's lights and cameras that its default scene does without, with the reason.
std::vector<std::string> unusedViews(const std::filesystem::path& file, const Model& model,
                                     const toml::table& scene);

} // namespace limpid::io
