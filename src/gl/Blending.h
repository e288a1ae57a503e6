#pragma once
#include "gl/Api.h"

namespace limpid::gl {

/// While it lives, what is drawn into draw buffer 0 is blended with what is there. No other draw buffer's
/// state changes: it may be a host's (gl/HostState.h).
struct Blending {
    Blending(GLenum source, GLenum target, GLenum equation = GL_FUNC_ADD) {
        glEnablei(GL_BLEND, 0);
        glBlendFunci(0, source, target);
        glBlendEquationi(0, equation);
    }
    ~Blending() {
        glBlendEquationi(0, GL_FUNC_ADD);
        glDisablei(GL_BLEND, 0);
    }
    Blending(const Blending&) = delete;
    Blending& operator=(const Blending&) = delete;
};

/// Added to what is there.
struct Adding : Blending {
    Adding() : Blending(GL_ONE, GL_ONE) {}
};

/// Multiplied with it.
struct Multiplying : Blending {
    Multiplying() : Blending(GL_ZERO, GL_SRC_COLOR) {}
};

} // namespace limpid::gl
