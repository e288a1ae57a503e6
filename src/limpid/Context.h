#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

namespace limpid {

namespace gl {
class Context;
}

/// What a context is asked for.
struct ContextOptions {
    std::string device{}; ///< EGL device by number or part of its name; empty: hardware first. Headless only
    std::int64_t memory = 0; ///< bytes that Limpid may hold on the GPU, >= 0; 0: as many as the driver gives
    bool debug = false;      ///< a debug context. Headless only: a host's is as the host made it
    /// Receives driver messages of a debug context; empty: they go to stderr.
    std::function<void(const std::string&)> onMessage{};
};

/// The OpenGL 4.5 core context that caustics are computed in. A handle: copies share the context, which goes
/// with the last of them. Every call on it and on Caustics needs the context to be current on this thread.
class Context {
  public:
    /// The host's context that is current on this thread, made by EGL, GLX or WGL. The host keeps it, its
    /// state and its thread, and destroys it after the last Caustics in it. Throws GraphicsError if none is
    /// current or it has no OpenGL 4.5, InputError for options out of range.
    static Context current(const ContextOptions& options = {});
    /// A context of Limpid's own, without window or display, made current on this thread. Throws
    /// GraphicsError if there is no EGL, no such device or no OpenGL 4.5, InputError as above.
    static Context headless(const ContextOptions& options = {});

    const std::string& renderer() const; ///< the GPU, in the driver's words
    std::int64_t bytes() const;          ///< that Limpid holds on the GPU now, as asked of the driver

  private:
    friend class Caustics;
    explicit Context(std::shared_ptr<gl::Context> context);
    std::shared_ptr<gl::Context> _context;
    const void* _handle; ///< that tells it from other contexts, as the window system has it
};

} // namespace limpid
