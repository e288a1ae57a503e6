// Loaded before the program's libraries, it stands for a driver that resets the GPU: after as many questions
// as LOST_AFTER says, the context is lost.
#include <cstdlib>

#include <GL/gl.h>
#include <GL/glext.h>

namespace {
GLenum status() {
    static int left = std::atoi(std::getenv("LOST_AFTER"));
    return left-- > 0 ? GL_NO_ERROR : GL_INNOCENT_CONTEXT_RESET;
}
} // namespace

extern "C" {
/// By the name of the pointer that libepoxy calls through.
__attribute__((visibility("default"))) GLenum (*epoxy_glGetGraphicsResetStatus)() = status;
}
