#pragma once
#include <span>

#include "apps/viewer/State.h"

namespace limpid::viewer {

/// One line of what `?` shows.
struct KeyHelp {
    const char* keys;
    const char* does;
};
std::span<const KeyHelp> keyHelp();

/// The part of the window that the picture fills, pixels.
struct Area {
    glm::ivec2 corner{0}, size{0};
};

/// What mouse and keys did since the last frame, to camera, time, selection and panels. `seconds` have passed
/// since. Between ImGui::NewFrame and the panels. Returns whether the user moved camera or receiver.
bool takeInput(State& state, const Area& picture, double seconds);

} // namespace limpid::viewer
