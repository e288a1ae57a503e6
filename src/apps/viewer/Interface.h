#pragma once
#include "apps/viewer/Keys.h"
#include "apps/viewer/Stage.h"
#include "apps/viewer/State.h"
#include "apps/viewer/Understanding.h"
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

/// What panels show and change.
struct Shows {
    State& state;
    Stage& stage;
    gl::Context& context;
    Measured& measured;
    Understanding& understanding;
};
/// Bars, panels, messages and the keys.
void drawInterface(const Shows& shows, const Layout& layout);

} // namespace limpid::viewer
