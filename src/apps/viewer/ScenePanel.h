#pragma once
#include "apps/viewer/State.h"

namespace limpid::viewer {

/// Everything of the scene that can be changed, section by section. Inside of a window of Dear ImGui.
void scenePanel(State& state);

/// A choice of one of the methods.
void methodCombo(const char* label, Method& method);

} // namespace limpid::viewer
