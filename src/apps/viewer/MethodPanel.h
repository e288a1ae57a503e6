#pragma once
#include "apps/viewer/State.h"

namespace limpid::viewer {

/// Sections of the scene's panel: how caustics and godrays are computed.
void methodSection(State& state);
void godraysSection(State& state);

/// The method of the caustics.
void methodField(Method& method);

} // namespace limpid::viewer
