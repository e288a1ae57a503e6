#include "gl/Reset.h"

#include <fmt/format.h>

#include "gl/Api.h"

namespace limpid::gl {

void requireContext() {
    const GLenum status = glGetGraphicsResetStatus();
    if (status == GL_NO_ERROR) return;
    const char* cause = status == GL_GUILTY_CONTEXT_RESET     ? "by what it was given to do"
                        : status == GL_INNOCENT_CONTEXT_RESET ? "by another program"
                                                              : "for a reason unknown";
    throw ContextLost(fmt::format("OpenGL: expected the GPU to stay, found it reset {}", cause));
}

} // namespace limpid::gl
