#pragma once
#include "gl/Api.h"

namespace limpid::gl {

/// While it lives, depth runs from 1 near by to 0 far away (shaders/view/view.glsl), whose single
/// precision is then as fine as the distances.
struct NearIsOne {
    NearIsOne() {
        glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
        glDepthFunc(GL_GREATER);
    }
    ~NearIsOne() {
        glClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
        glDepthFunc(GL_LESS);
    }
    NearIsOne(const NearIsOne&) = delete;
    NearIsOne& operator=(const NearIsOne&) = delete;
};

} // namespace limpid::gl
