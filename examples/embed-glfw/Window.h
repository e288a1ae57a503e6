#pragma once
#include <string>

#include <glm/glm.hpp>

struct GLFWwindow;

/// A window with an OpenGL 4.5 core context, current on this thread. Throws std::runtime_error without a
/// display.
class Window {
  public:
    Window(glm::ivec2 size, const char* title);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    /// Shows what was drawn and takes events. False once the user closes it.
    bool show();
    double seconds() const;
    glm::ivec2 size() const; ///< of the framebuffer, pixels
    /// What was drawn last and is not yet shown, as a PNG.
    void save(const std::string& file) const;

  private:
    GLFWwindow* _window = nullptr;
};
