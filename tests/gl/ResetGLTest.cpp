// The driver resets the GPU: what is read from it then is an error, whatever it seems to be.
#include <gmock/gmock.h>

#include "gl/GLFixture.h"
#include "gl/Handles.h"
#include "gl/Reset.h"

namespace limpid::gl {
namespace {

class ResetGLTest : public GLTest {
  protected:
    void SetUp() override {
        GLTest::SetUp();
        requireContext();
        _true = epoxy_glGetGraphicsResetStatus;
    }
    void TearDown() override {
        epoxy_glGetGraphicsResetStatus = _true;
        GLTest::TearDown();
    }
    static void reset() {
        epoxy_glGetGraphicsResetStatus = [] { return GLenum(GL_GUILTY_CONTEXT_RESET); };
    }

  private:
    PFNGLGETGRAPHICSRESETSTATUSPROC _true = nullptr;
};

TEST_F(ResetGLTest, mesaIsAskedToTell) {
    if (context().info().version.find("Mesa") == std::string::npos) return; // others may not be able to
    GLint strategy = 0;
    glGetIntegerv(GL_RESET_NOTIFICATION_STRATEGY, &strategy);
    EXPECT_EQ(GLenum(strategy), GLenum(GL_LOSE_CONTEXT_ON_RESET));
}

TEST_F(ResetGLTest, nothingIsReadFromALostContext) {
    Buffer buffer(context().ledger(), "buffer", 64);
    Texture texture(context().ledger(), "texture", GL_R32F, {4, 4});
    EXPECT_EQ(texture.readFloats(GL_RED, 1).size(), 16u);
    reset();
    EXPECT_THROW(buffer.read<float>(16), ContextLost);
    EXPECT_THROW(texture.readFloats(GL_RED, 1), ContextLost);
    try {
        requireContext();
    } catch (const GraphicsError& error) {
        EXPECT_STREQ(error.what(),
                     "OpenGL: expected the GPU to stay, found it reset by what it was given to do");
    }
}

TEST_F(ResetGLTest, anErrorOfALostContextIsNotWantOfMemory) {
    const auto asked = epoxy_glGetError;
    epoxy_glGetError = [] { return GLenum(GL_CONTEXT_LOST); };
    EXPECT_THROW(Buffer(context().ledger(), "buffer", 64), GraphicsError);
    reset();
    EXPECT_THROW(Buffer(context().ledger(), "buffer", 64), ContextLost);
    epoxy_glGetError = asked;
    EXPECT_EQ(context().ledger().bytes("buffer"), 0);
}

} // namespace
} // namespace limpid::gl
