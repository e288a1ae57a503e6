#pragma once
#include <optional>
#include <string>

namespace limpid::gl {

/// The window system interface that made the OpenGL context which is current on this thread: "EGL", "GLX" or
/// "WGL"; none where no context is. Loads none of them: what made a context is loaded already.
std::optional<std::string> currentContext();
/// What tells that context from others; null where none is current.
const void* currentHandle();

} // namespace limpid::gl
