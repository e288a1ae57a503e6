#include "gl/CurrentContext.h"

#ifdef _WIN32
#define WIN32_LEAN_AND_MEAN
#include <windows.h>
#else
#include <dlfcn.h>
#endif

namespace limpid::gl {

#ifdef _WIN32

std::optional<std::string> currentContext() {
    if (wglGetCurrentContext()) return "WGL";
    return std::nullopt;
}

#else

namespace {

using Current = void* (*)();

/// Whether a library that is loaded has a function of this name that gives a context.
bool gives(const char* library, const char* function) {
    void* const loaded = dlopen(library, RTLD_LAZY | RTLD_NOLOAD);
    if (!loaded) return false;
    const auto current = reinterpret_cast<Current>(dlsym(loaded, function));
    const bool found = current && current();
    dlclose(loaded);
    return found;
}

} // namespace

std::optional<std::string> currentContext() {
    if (gives("libEGL.so.1", "eglGetCurrentContext")) return "EGL";
    for (const char* library : {"libGLX.so.0", "libGL.so.1"})
        if (gives(library, "glXGetCurrentContext")) return "GLX";
    return std::nullopt;
}

#endif

} // namespace limpid::gl
