#pragma once
#include "apps/viewer/Keys.h"
#include "apps/viewer/Stage.h"
#include "apps/viewer/State.h"
#include "gl/Context.h"

namespace limpid::viewer {

/// What the interface is laid out by.
struct Layout {
    glm::ivec2 window{0};                           ///< pixels
    Area picture;                                   ///< what panels leave of it
    float top = 0, left = 0, right = 0, bottom = 0; ///< heights of the bars, widths of the panels
};
Layout layoutOf(const State& state, glm::ivec2 window);

/// Shows the picture in its place.
void drawPicture(const Stage& stage, const Layout& layout);

/// Bars, the scene's panel, messages and the keys.
void drawInterface(State& state, const Stage& stage, const gl::Context& context, const Layout& layout);

} // namespace limpid::viewer
