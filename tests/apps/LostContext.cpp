// Loaded before the program's libraries, it stands for a driver that resets the GPU: after as many questions
// as LOST_AFTER says, the context is lost.
#include <cstdlib>

namespace {
constexpr unsigned noError = 0, innocentContextReset = 0x8254; // as OpenGL numbers them

unsigned status() {
    static int left = std::atoi(std::getenv("LOST_AFTER"));
    return left-- > 0 ? noError : innocentContextReset;
}
} // namespace

extern "C" {
/// By the name of the pointer that libepoxy calls through.
__attribute__((visibility("default"))) unsigned (*epoxy_glGetGraphicsResetStatus)() = status;
}
