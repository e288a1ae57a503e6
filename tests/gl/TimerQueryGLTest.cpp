#include "gl/TimerQuery.h"

#include <malloc.h>

#include "gl/GLFixture.h"

namespace limpid {
namespace {

class TimerQueryGLTest : public GLTest {
  protected:
    static void time(gl::PassTimers& timers, int scopes) {
        for (int i = 0; i < scopes; ++i)
            const gl::PassTimers::Scope scope(timers, i % 2 ? "odd" : "even");
    }
    static std::size_t heapBytes() {
        const struct mallinfo2 info = mallinfo2();
        return info.uordblks + info.hblkhd;
    }
};

TEST_F(TimerQueryGLTest, passesNestAndAreSummedByName) {
    gl::PassTimers timers;
    {
        const gl::PassTimers::Scope outer(timers, "outer");
        time(timers, 10);
    }
    const auto times = timers.collect();
    ASSERT_EQ(times.size(), 3u);
    EXPECT_EQ(times[0].first, "outer");
    EXPECT_GE(times[0].second, times[1].second + times[2].second);
    EXPECT_TRUE(timers.collect().empty());
}

// An engine whose owner never asks for times: queries heaped up, 40 kB a frame.
TEST_F(TimerQueryGLTest, timesThatNobodyAsksForTakeNoMemory) {
    gl::PassTimers timers;
    time(timers, 10000);
    const std::size_t before = heapBytes();
    time(timers, 40000);
    // A query is some hundred bytes of the driver's.
    EXPECT_LT(heapBytes(), before + 1000000);
    EXPECT_EQ(timers.collect().size(), 2u) << "and none is lost";
}

TEST_F(TimerQueryGLTest, aScopeThatHoldsManyMoreIsStillTimed) {
    gl::PassTimers timers;
    {
        const gl::PassTimers::Scope outer(timers, "outer");
        time(timers, 10000);
    }
    EXPECT_EQ(timers.collect().front().first, "outer");
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
}

} // namespace
} // namespace limpid
