#include "gl/Context.h"

#include <gmock/gmock.h>

#include "core/Error.h"
#include "gl/GLFixture.h"
#include "gl/Handles.h"
#include "gl/Program.h"
#include "gl/TimerQuery.h"

namespace limpid::gl {
namespace {

using ::testing::HasSubstr;

class ContextGLTest : public GLTest {};

TEST_F(ContextGLTest, isCoreFourFive) {
    EXPECT_GE(context().info().maxTextureSize, 8192);
    EXPECT_GE(context().info().maxComputeInvocations, 64);
    EXPECT_THAT(context().info().version, HasSubstr("4."));
    GLint profile = 0;
    glGetIntegerv(GL_CONTEXT_PROFILE_MASK, &profile);
    EXPECT_EQ(profile, GL_CONTEXT_CORE_PROFILE_BIT);
}

TEST_F(ContextGLTest, subpixelGridIsTheOneTheMethodsAssume) {
    EXPECT_GE(context().info().subpixelBits, 8);
}

TEST_F(ContextGLTest, handlesFreeTheirBytes) {
    Ledger ledger;
    {
        Buffer buffer(ledger, "buffers", 1024);
        Texture texture(ledger, "textures", GL_RGBA32F, {16, 8});
        EXPECT_EQ(ledger.bytes("textures"), 16 * 8 * 16);
        Buffer moved(std::move(buffer));
        EXPECT_EQ(buffer.id(), 0u);
        EXPECT_EQ(ledger.total(), 1024 + 2048);
        moved = Buffer(ledger, "buffers", 512);
        EXPECT_EQ(ledger.bytes("buffers"), 512);
    }
    EXPECT_EQ(ledger.total(), 0);
}

TEST_F(ContextGLTest, buffersKeepWhatIsWritten) {
    Ledger ledger;
    const std::vector<int> numbers{1, 2, 3};
    const Buffer buffer(ledger, "numbers", std::span<const int>(numbers));
    EXPECT_EQ(buffer.read<int>(3), numbers);
    EXPECT_GE(buffer.bytes(), 12);
}

TEST_F(ContextGLTest, aFailingShaderIsNamed) {
    const std::vector<std::string> broken{"main broken("};
    try {
        Program program({"water/beams.comp"}, broken);
        FAIL();
    } catch (const GraphicsError& error) {
        EXPECT_THAT(error.what(), HasSubstr("shaders/water/beams.comp: does not compile"));
    }
    messages().clear();
}

TEST_F(ContextGLTest, timersNameTheirPasses) {
    PassTimers timers;
    { PassTimers::Scope scope(timers, "first"); }
    { PassTimers::Scope scope(timers, "second"); }
    { PassTimers::Scope scope(timers, "first"); }
    const auto times = timers.collect();
    ASSERT_EQ(times.size(), 2u);
    EXPECT_EQ(times[0].first, "first");
    EXPECT_EQ(times[1].first, "second");
    EXPECT_LT(times[0].second, 10000) << "milliseconds of nothing";
    EXPECT_TRUE(timers.collect().empty());
}

TEST_F(ContextGLTest, anUnknownDeviceIsAnError) {
    ContextOptions options;
    options.device = "no such device";
    try {
        Context other(options);
        FAIL();
    } catch (const GraphicsError& error) {
        EXPECT_THAT(error.what(),
                    HasSubstr("EGL: expected a device named or numbered \"no such device\", found 0 ("));
    }
}

} // namespace
} // namespace limpid::gl
