#pragma once
#include "apps/viewer/State.h"

namespace limpid::viewer {

/// Sections of the scene's panel: how caustics and godrays are computed.
void methodSection(State& state);
void godraysSection(State& state);

/// A choice of one of the methods.
void methodCombo(const char* label, Method& method);

} // namespace limpid::viewer
