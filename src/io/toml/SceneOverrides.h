#pragma once
#include <vector>

#include <toml++/toml.h>

#include "io/toml/SceneFile.h"

namespace limpid::io {

/// Sets each override's key in `root`, in order. Entries of arrays of tables are found by name, else by
/// number; tables that are not there yet are made. Throws InputError for an entry that does not exist.
/// Whether the scene knows the key shows when the table is parsed.
void applyOverrides(toml::table& root, const std::vector<Override>& overrides);

} // namespace limpid::io
