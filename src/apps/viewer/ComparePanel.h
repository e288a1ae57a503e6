#pragma once
#include "apps/viewer/Keys.h"
#include "apps/viewer/State.h"

namespace limpid::viewer {

/// A second method and how it is shown beside the first. Inside of a window of Dear ImGui.
void comparePanel(State& state);

/// The line between the two and their names, over the picture.
void compareOverlay(const State& state, const Area& picture);

} // namespace limpid::viewer
