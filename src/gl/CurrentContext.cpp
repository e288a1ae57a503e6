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

const void* currentHandle() {
    return wglGetCurrentContext();
}

#else

namespace {

using Current = void* (*)();

/// The context that a function of this name gives, if a library that is loaded has it.
void* given(const char* library, const char* function) {
    void* const loaded = dlopen(library, RTLD_LAZY | RTLD_NOLOAD);
    if (!loaded) return nullptr;
    const auto current = reinterpret_cast<Current>(dlsym(loaded, function));
    void* const context = current ? current() : nullptr;
    dlclose(loaded);
    return context;
}

void* egl() {
    return given("libEGL.so.1", "eglGetCurrentContext");
}

void* glx() {
    for (const char* library : {"libGLX.so.0", "libGL.so.1"})
        if (void* const context = given(library, "glXGetCurrentContext")) return context;
    return nullptr;
}

} // namespace

std::optional<std::string> currentContext() {
    if (egl()) return "EGL";
    if (glx()) return "GLX";
    return std::nullopt;
}

const void* currentHandle() {
    const void* const context = egl();
    return context ? context : glx();
}

#endif

} // namespace limpid::gl
