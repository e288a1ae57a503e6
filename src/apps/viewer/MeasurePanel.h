#pragma once
#include "apps/viewer/Stage.h"
#include "apps/viewer/State.h"
#include "gl/Context.h"

namespace limpid::viewer {

/// Times by pass, memory by kind, what was left out, and the GPU. Inside of a window of Dear ImGui.
void measurePanel(Measured& measured, Stage& stage, gl::Context& context);

} // namespace limpid::viewer
