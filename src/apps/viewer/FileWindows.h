#pragma once
#include "apps/viewer/State.h"

namespace limpid::viewer {

/// The small windows that ask for a file to open and for one to save the scene to.
void fileWindows(State& state);

} // namespace limpid::viewer
