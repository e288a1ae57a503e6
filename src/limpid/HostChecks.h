#pragma once
#include "scene/Scene.h"

namespace limpid {

/// Throws InputError (place, expected, got) where a host's texture is not what the scene says of it. Needs a
/// current context; changes no state.
void requireHostTextures(const Water& water);

} // namespace limpid
