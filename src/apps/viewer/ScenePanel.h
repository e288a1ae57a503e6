#pragma once
#include "apps/viewer/State.h"

namespace limpid::viewer {

/// Everything of the scene that can be changed, section by section. Inside of a window of Dear ImGui.
void scenePanel(State& state);

} // namespace limpid::viewer
