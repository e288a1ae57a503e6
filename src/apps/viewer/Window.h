#pragma once
#include <filesystem>
#include <memory>
#include <vector>

#include <glm/glm.hpp>

#include "apps/viewer/Events.h"
#include "gl/Context.h"

struct GLFWwindow;

namespace limpid::viewer {

/// A window with an OpenGL 4.5 core context by EGL, and Dear ImGui in it.
class Window {
  public:
    struct Options {
        glm::ivec2 size{1280, 720}; ///< screen units
        double interfaceScale = 0;  ///< of text and controls; 0: as the display asks for
        bool debug = false;         ///< a debug context
    };
    /// Throws GraphicsError without a display, or without such a context.
    explicit Window(const Options& options);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    bool closes() const;
    void close();
    void setTitle(const std::string& title);
    void setFullscreen(bool on);
    bool fullscreen() const { return _fullscreen; }
    /// Pixels.
    glm::ivec2 size() const;
    /// Whether nobody can see it: minimised, or of no size.
    bool hidden() const;
    double interfaceScale() const { return _scale; }

    /// Waits for up to `seconds` for mouse or keyboard to do something, unless there is more to take already.
    void waitForEvents(double seconds);
    /// Whether the next frame takes an event.
    bool hasEvents() const { return !_events.empty(); }
    /// Files dropped onto the window since the last call.
    std::vector<std::filesystem::path> takeDropped();

    /// Everything of the interface is made between the two; the second draws it, and lets it be seen after
    /// `before` has looked at the finished pixels.
    void beginInterface();
    template <typename Before>
    void endInterface(Before&& before) {
        drawInterface();
        before();
        swap();
    }
    /// What is in the window, RGB, rows from the top.
    std::vector<std::uint8_t> pixels() const;

  private:
    void create(const Options& options);
    void listen();
    void take(const Event& event);
    void startInterface(double scale);
    void drawInterface();
    void swap();

    struct Glfw {
        Glfw();
        ~Glfw();
        Glfw(const Glfw&) = delete;
        Glfw& operator=(const Glfw&) = delete;
    };
    Glfw _glfw;
    GLFWwindow* _window = nullptr;
    double _scale = 1;
    bool _fullscreen = false;
    glm::ivec4 _windowed{0};
    std::vector<std::filesystem::path> _dropped;
    EventQueue _events;
    glm::dvec2 _mouse{0};
    std::array<bool, 5> _buttons{};
};

} // namespace limpid::viewer
