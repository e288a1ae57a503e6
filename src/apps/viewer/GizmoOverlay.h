#pragma once
#include "apps/viewer/Keys.h"
#include "apps/viewer/State.h"

namespace limpid::viewer {

/// Lets the mouse take the picked receiver's handles. Returns whether it has one, and means nothing else by
/// what it does.
bool takeGizmo(State& state, const Area& picture);

/// The handles, over the picture.
void drawGizmo(const State& state, const Area& picture);

} // namespace limpid::viewer
