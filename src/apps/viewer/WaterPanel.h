#pragma once
#include "apps/viewer/State.h"

namespace limpid::viewer {

/// Sections of the scene's panel. `speed`: m a pixel of a drag.
void waterSection(State& state, double speed);
void wavesSection(State& state, double speed);

} // namespace limpid::viewer
