#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include <toml++/toml.h>

#include "scene/Model.h"

namespace limpid::io {

/// The scene of a model given alone. A basin (scene/Basin.h) is filled to below its rim, or to where its
/// author modelled the water; anything else stands on a floor in water deep enough to cover it. Waves are in
/// proportion to the depth, so that they focus light on the ground whatever the model's size. The model's own
/// lights stand for the sun if any of them gets into the water; its first camera stands for ours if it sees
/// the model clear of the waves: of a sunken model, the level follows it. A table, so that `--set` reaches
/// every entry of it.
toml::table defaultScene(const std::filesystem::path& file, const Model& model);

/// Notices of the model's lights and cameras that its default scene does without, with the reason.
std::vector<std::string> unusedViews(const std::filesystem::path& file, const Model& model,
                                     const toml::table& scene);

} // namespace limpid::io
