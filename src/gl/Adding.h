#pragma once
#include "gl/Api.h"

namespace limpid::gl {

/// While it lives, what is drawn is added to what is there.
struct Adding {
    Adding() {
        glEnable(GL_BLEND);
        glBlendFunc(GL_ONE, GL_ONE);
    }
    ~Adding() { glDisable(GL_BLEND); }
    Adding(const Adding&) = delete;
    Adding& operator=(const Adding&) = delete;
};

} // namespace limpid::gl
