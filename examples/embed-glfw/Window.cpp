#include "Window.h"

#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include <epoxy/gl.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <limpid/io/images/Images.h>

namespace {
[[noreturn]] void fail() {
    const char* text = nullptr;
    glfwGetError(&text);
    const std::string error = text ? text : "no window";
    glfwTerminate();
    throw std::runtime_error("GLFW: " + error);
}
} // namespace

Window::Window(glm::ivec2 size, const char* title) {
    if (!glfwInit()) fail();
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    _window = glfwCreateWindow(size.x, size.y, title, nullptr, nullptr);
    if (!_window) fail();
    glfwMakeContextCurrent(_window);
}

Window::~Window() {
    glfwDestroyWindow(_window);
    glfwTerminate();
}

bool Window::show() {
    glfwSwapBuffers(_window);
    glfwPollEvents();
    return !glfwWindowShouldClose(_window);
}

double Window::seconds() const {
    return glfwGetTime();
}

glm::ivec2 Window::size() const {
    glm::ivec2 size;
    glfwGetFramebufferSize(_window, &size.x, &size.y);
    return size;
}

void Window::save(const std::string& file) const {
    const glm::ivec2 pixels = size();
    std::vector<std::uint8_t> rows(std::size_t(3 * pixels.x * pixels.y)), image;
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, pixels.x, pixels.y, GL_RGB, GL_UNSIGNED_BYTE, rows.data());
    for (int y = pixels.y - 1; y >= 0; --y) // OpenGL's first row is the bottom one
        image.insert(image.end(), rows.begin() + 3 * pixels.x * y, rows.begin() + 3 * pixels.x * (y + 1));
    limpid::io::writePng(file, pixels.x, pixels.y, image);
}
