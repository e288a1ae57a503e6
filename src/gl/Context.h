#pragma once
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gl/Ledger.h"

namespace limpid::gl {

/// What the program asks of the graphics system before it exists.
struct ContextOptions {
    std::string
        device; ///< EGL device by number or part of its name; empty: the first with hardware, else any
    std::int64_t memory = 0; ///< bytes on the GPU at the most; 0: as many as the driver gives
    bool debug = false;      ///< debug context whose messages go to `onMessage`
    /// Receives each message of high or medium severity. Without it, errors go to stderr.
    std::function<void(const std::string&)> onMessage;
};

/// One EGL device that could be chosen.
struct DeviceDescription {
    int index = 0;
    std::string name; ///< DRM file, or "software"
    bool software = false;
};

/// What is known of the chosen GPU and what the engine will use of it.
struct DeviceInfo {
    std::string vendor, renderer, version, glsl, egl, platform;
    int maxTextureSize = 0;
    int maxTextureLayers = 0;
    int maxComputeInvocations = 0;
    int subpixelBits = 0;
    std::int64_t maxStorageBlockBytes = 0;
};

/// A line for who waits for a GPU and gets none: hardware is among `devices`, but `platform`, as DeviceInfo
/// has it, is software. Empty where there is no such thing to say.
std::string softwareWord(std::span<const DeviceDescription> devices, std::string_view platform);

/// An OpenGL 4.5 core context, by default without window or display, current on the thread that made it.
/// First choice is EGL's device platform, then the surfaceless one.
/// Throws GraphicsError when there is no EGL, no such device, no OpenGL 4.5, or fewer storage buffers than
/// the shaders have (gl/Bindings.h).
///
/// In a context of its own every pass leaves OpenGL's state as it found it, a fresh one. In a host's, Guard
/// (gl/Guard.h) stands between the two.
class Context {
  public:
    explicit Context(const ContextOptions& options = {});
    /// The context that is current already, made by EGL, GLX or WGL for a window, say: it is used and stays
    /// its owner's, the host's. Throws GraphicsError when there is none, or none with OpenGL 4.5.
    struct Current {};
    Context(Current, const ContextOptions& options);
    ~Context();
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;

    Ledger& ledger() { return _ledger; }
    const DeviceInfo& info() const { return _info; }

    static std::vector<DeviceDescription> devices();

  private:
    friend class Guard;
    /// True for a guard that has something to keep: the outermost one in a host's context.
    bool enter() { return _guards++ == 0 && _isHosts; }
    void leave() { --_guards; }

    struct Egl;
    void listenAndQuery(const ContextOptions& options, const std::string& platform);
    std::unique_ptr<Egl> _egl;
    std::function<void(const std::string&)> _onMessage;
    Ledger _ledger;
    DeviceInfo _info;
    bool _isHosts = false;
    int _guards = 0;
};

} // namespace limpid::gl
