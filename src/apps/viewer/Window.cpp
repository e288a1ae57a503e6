#include "apps/viewer/Window.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <cstring>
#include <utility>

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <fmt/format.h>
#include <imgui.h>

#include "core/Error.h"
#include "gl/Api.h"
#include "gl/Reset.h"
// After OpenGL's own declarations, so that it brings none.
#include <GLFW/glfw3.h>

namespace limpid::viewer {

namespace {

std::string lastError() {
    const char* description = nullptr;
    glfwGetError(&description);
    std::string line = description ? description : "no reason given";
    std::replace(line.begin(), line.end(), '\n', ' ');
    return line;
}

/// A font whose letters are readable at any size; Dear ImGui's own is made of pixels.
constexpr const char* fontFile = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";
constexpr float fontSize = 15;

void loadFont(double scale) {
    ImGuiIO& io = ImGui::GetIO();
    const float pixels = std::round(fontSize * float(scale));
    // Letters beyond Latin that texts of the interface hold.
    static const ImWchar ranges[] = {0x20,   0xFF,   0x2013, 0x2026, 0x2070, 0x2099,
                                     0x2190, 0x2193, 0x2212, 0x2212, 0};
    if (std::FILE* file = std::fopen(fontFile, "rb")) {
        std::fclose(file);
        io.Fonts->AddFontFromFileTTF(fontFile, pixels, nullptr, ranges);
        return;
    }
    ImFontConfig config;
    config.SizePixels = pixels;
    io.Fonts->AddFontDefault(&config);
}

void setStyle(double scale) {
    ImGui::StyleColorsDark();
    ImGuiStyle& style = ImGui::GetStyle();
    style.WindowRounding = 0;
    style.FrameRounding = 3;
    style.GrabRounding = 3;
    style.WindowBorderSize = 0;
    style.Colors[ImGuiCol_WindowBg] = ImVec4(0.09f, 0.10f, 0.12f, 1.0f);
    style.Colors[ImGuiCol_PopupBg] = ImVec4(0.11f, 0.12f, 0.14f, 0.98f);
    style.ScaleAllSizes(float(scale));
}

} // namespace

Window::Glfw::Glfw() {
    glfwSetErrorCallback(nullptr);
    if (!glfwInit()) throw GraphicsError(fmt::format("no display to open a window on: {}", lastError()));
}

Window::Glfw::~Glfw() {
    glfwTerminate();
}

Window::Window(const Options& options) {
    create(options);
    listen();
    float x = 1, y = 1;
    glfwGetWindowContentScale(_window, &x, &y);
    startInterface(options.interfaceScale > 0 ? options.interfaceScale : double(std::max(x, 1.0f)));
}

/// Everything goes through the queue; Dear ImGui's own way of asking for the state of things would miss some.
void Window::listen() {
    glfwSetWindowUserPointer(_window, this);
    static const auto of = [](GLFWwindow* window) -> Window& {
        return *static_cast<Window*>(glfwGetWindowUserPointer(window));
    };
    using Type = Event::Type;
    glfwSetDropCallback(_window, [](GLFWwindow* window, int count, const char** paths) {
        of(window)._dropped.insert(of(window)._dropped.end(), paths, paths + count);
    });
    glfwSetCursorPosCallback(_window, [](GLFWwindow* window, double x, double y) {
        of(window)._events.push({Type::Move, {x, y}});
    });
    glfwSetCursorEnterCallback(_window, [](GLFWwindow* window, int entered) {
        if (!entered) of(window)._events.push({Type::Leave});
    });
    glfwSetMouseButtonCallback(_window, [](GLFWwindow* window, int button, int action, int modifiers) {
        of(window)._events.push({Type::Button, {}, button, 0, action, modifiers});
    });
    glfwSetScrollCallback(_window, [](GLFWwindow* window, double x, double y) {
        of(window)._events.push({Type::Wheel, {x, y}});
    });
    glfwSetKeyCallback(_window, [](GLFWwindow* window, int key, int scancode, int action, int modifiers) {
        of(window)._events.push({Type::Key, {}, key, scancode, action, modifiers});
    });
    glfwSetCharCallback(_window, [](GLFWwindow* window, unsigned letter) {
        of(window)._events.push({Type::Letter, {}, int(letter)});
    });
    glfwGetCursorPos(_window, &_mouse.x, &_mouse.y);
}

void Window::take(const Event& event) {
    switch (event.type) {
    case Event::Type::Move:
        _mouse = event.at;
        break;
    case Event::Type::Leave:
        _mouse = glm::dvec2(-FLT_MAX);
        break;
    case Event::Type::Button:
        if (event.code >= 0 && event.code < int(_buttons.size()))
            _buttons[std::size_t(event.code)] = event.action == GLFW_PRESS;
        break;
    case Event::Type::Wheel:
        ImGui_ImplGlfw_ScrollCallback(_window, event.at.x, event.at.y);
        break;
    case Event::Type::Key:
        ImGui_ImplGlfw_KeyCallback(_window, event.code, event.scancode, event.action, event.modifiers);
        break;
    case Event::Type::Letter:
        ImGui_ImplGlfw_CharCallback(_window, unsigned(event.code));
        break;
    }
}

void Window::create(const Options& options) {
    glfwWindowHint(GLFW_CONTEXT_CREATION_API, GLFW_EGL_CONTEXT_API);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_DEBUG_CONTEXT, options.debug ? GLFW_TRUE : GLFW_FALSE);
    // Nothing is drawn into the window itself but flat pictures.
    glfwWindowHint(GLFW_DEPTH_BITS, 0);
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
    // A driver that cannot tell of a reset may refuse a context that is to.
    for (const int robustness : {GLFW_LOSE_CONTEXT_ON_RESET, GLFW_NO_ROBUSTNESS}) {
        glfwWindowHint(GLFW_CONTEXT_ROBUSTNESS, robustness);
        _window = glfwCreateWindow(options.size.x, options.size.y, "Limpid", nullptr, nullptr);
        if (_window) break;
    }
    if (!_window)
        throw GraphicsError(
            fmt::format("expected a window with OpenGL 4.5 core by EGL, found {}", lastError()));
    glfwMakeContextCurrent(_window);
    glfwSwapInterval(1);
}

void Window::startInterface(double scale) {
    _scale = scale;
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    setStyle(scale);
    loadFont(scale);
    ImGui_ImplGlfw_InitForOpenGL(_window, false);
    ImGui_ImplOpenGL3_Init("#version 450 core");
}

Window::~Window() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
    glfwDestroyWindow(_window);
}

bool Window::closes() const {
    return glfwWindowShouldClose(_window);
}

void Window::close() {
    glfwSetWindowShouldClose(_window, GLFW_TRUE);
}

void Window::setTitle(const std::string& title) {
    glfwSetWindowTitle(_window, title.c_str());
}

void Window::setFullscreen(bool on) {
    if (on == _fullscreen) return;
    GLFWmonitor* monitor = glfwGetPrimaryMonitor();
    const GLFWvidmode* mode = monitor ? glfwGetVideoMode(monitor) : nullptr;
    if (on && !mode) return;
    _fullscreen = on;
    if (on) {
        glfwGetWindowPos(_window, &_windowed.x, &_windowed.y);
        glfwGetWindowSize(_window, &_windowed.z, &_windowed.w);
        glfwSetWindowMonitor(_window, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
    } else {
        glfwSetWindowMonitor(_window, nullptr, _windowed.x, _windowed.y, _windowed.z, _windowed.w, 0);
    }
}

glm::ivec2 Window::size() const {
    glm::ivec2 size;
    glfwGetFramebufferSize(_window, &size.x, &size.y);
    return size;
}

bool Window::hidden() const {
    const glm::ivec2 pixels = size();
    return pixels.x < 1 || pixels.y < 1 || glfwGetWindowAttrib(_window, GLFW_ICONIFIED) ||
           !glfwGetWindowAttrib(_window, GLFW_VISIBLE);
}

void Window::waitForEvents(double seconds) {
    if (seconds > 0 && _events.empty())
        glfwWaitEventsTimeout(seconds);
    else
        glfwPollEvents();
}

std::vector<std::filesystem::path> Window::takeDropped() {
    return std::exchange(_dropped, {});
}

void Window::beginInterface() {
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    _events.takeFrame([&](const Event& event) { take(event); });
    ImGuiIO& io = ImGui::GetIO();
    io.MousePos = ImVec2(float(_mouse.x), float(_mouse.y));
    std::copy(_buttons.begin(), _buttons.end(), io.MouseDown);
    ImGui::NewFrame();
}

void Window::drawInterface() {
    ImGui::Render();
    const glm::ivec2 pixels = size();
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, pixels.x, pixels.y);
    constexpr float black[] = {0, 0, 0, 1};
    glClearBufferfv(GL_COLOR, 0, black);
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

void Window::swap() {
    glfwSwapBuffers(_window);
    gl::requireContext();
}

std::vector<std::uint8_t> Window::pixels() const {
    const glm::ivec2 count = size();
    const std::size_t row = std::size_t(count.x) * 3;
    std::vector<std::uint8_t> upward(row * std::size_t(count.y)), out(upward.size());
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
    glReadPixels(0, 0, count.x, count.y, GL_RGB, GL_UNSIGNED_BYTE, upward.data());
    gl::requireContext();
    for (std::size_t y = 0; y < std::size_t(count.y); ++y)
        std::memcpy(&out[y * row], &upward[(std::size_t(count.y) - 1 - y) * row], row);
    return out;
}

} // namespace limpid::viewer
