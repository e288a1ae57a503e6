// The engine in the context of a host's own window, whichever interface made it.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <gmock/gmock.h>

#include "core/Error.h"
#include "engine/Engine.h"
#include "engine/Readback.h"
#include "engine/Scenes.h"
#include "viewer/Display.h"

namespace limpid {
namespace {

/// A window with a context of OpenGL 4.5, current while it lives.
class HostWindow {
  public:
    explicit HostWindow(int contextApi) {
        glfwWindowHint(GLFW_CONTEXT_CREATION_API, contextApi);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
        glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
        _window = glfwCreateWindow(64, 48, "host", nullptr, nullptr);
        if (_window) glfwMakeContextCurrent(_window);
    }
    ~HostWindow() {
        if (_window) glfwDestroyWindow(_window);
    }
    HostWindow(const HostWindow&) = delete;
    HostWindow& operator=(const HostWindow&) = delete;

    bool isThere() const { return _window != nullptr; }

  private:
    GLFWwindow* _window = nullptr;
};

class HostContextGLTest : public ::testing::Test {
  protected:
    static void SetUpTestSuite() {
        _folder = std::filesystem::temp_directory_path() / ("limpid-host-" + std::to_string(getpid()));
        std::filesystem::create_directories(_folder);
        _display = std::make_unique<test::Display>(_folder, glm::ivec2(320, 240));
        setenv("DISPLAY", _display->name().c_str(), 1);
        ASSERT_TRUE(glfwInit()) << "Xvfb did not start: install what tools/packages lists";
    }
    static void TearDownTestSuite() {
        glfwTerminate();
        _display.reset();
        std::filesystem::remove_all(_folder);
    }

    static std::vector<float> baked(gl::Context& context) {
        Engine engine(context);
        Scene scene = scenes::floorPastSphere(30);
        scene.water.waves = {scenes::cosine(0.01, 0.5, {1, 0.3})};
        scene.caustics.mapSize = 64;
        engine.set(scene);
        engine.updateCaustics(0);
        return readMaps(engine.maps()[0], engine.origin()).irradiance;
    }

    static inline std::filesystem::path _folder;
    static inline std::unique_ptr<test::Display> _display;
};

TEST_F(HostContextGLTest, glxAndEglGiveWhatAContextOfOurOwnGives) {
    const std::vector<float> own = [] {
        gl::Context context;
        return baked(context);
    }();
    for (const auto& [api, name] : {std::pair(GLFW_NATIVE_CONTEXT_API, "window (GLX)"),
                                    std::pair(GLFW_EGL_CONTEXT_API, "window (EGL)")}) {
        SCOPED_TRACE(name);
        const HostWindow window(api);
        ASSERT_TRUE(window.isThere());
        gl::Context context(gl::Context::Current{}, {});
        EXPECT_EQ(context.info().platform, name);
        EXPECT_TRUE(baked(context) == own);
    }
}

TEST_F(HostContextGLTest, withoutOneTheErrorSaysSo) {
    try {
        gl::Context context(gl::Context::Current{}, {});
        FAIL();
    } catch (const GraphicsError& error) {
        EXPECT_STREQ(error.what(), "OpenGL: expected a context that is current on this thread, found none");
    }
}

} // namespace
} // namespace limpid
