#pragma once
#include <string>
#include <vector>

#include <toml++/toml.h>

#include "io/toml/SceneSettings.h"

namespace limpid::io {

/// The text of a scene file with some settings changed, added or taken out and all else, comments included,
/// as it was.
/// `root` is what `text` was parsed to. Whether the result says what was meant is for the caller to check: a
/// table written in one line, say, is left alone.
std::string patchSettings(const std::string& text, const toml::table& root,
                          const std::vector<Setting>& settings);

/// Takes all waves and the preset out of the text, and puts these in their place.
std::string replaceWaves(const std::string& text, const toml::table& root, const std::string& waves);

} // namespace limpid::io
