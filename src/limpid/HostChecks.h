#pragma once
#include <vector>

#include "scene/Scene.h"

namespace limpid {

/// Throws InputError (place, expected, got) where a host's texture is not what the scene says of it. Needs a
/// current context; changes no state.
void requireHostTextures(const Water& water);
/// Likewise for a host's buffers.
void requireHostBuffers(const std::vector<Receiver>& receivers);

} // namespace limpid
