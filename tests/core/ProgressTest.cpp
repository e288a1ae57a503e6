#include "core/Progress.h"

#include <gtest/gtest.h>

namespace limpid {
namespace {

TEST(Progress, tellsTheTimeLeft) {
    EXPECT_EQ(Progress::text("frames", 0, 10, 0), "frames 0/10");
    EXPECT_EQ(Progress::text("frames", 2, 10, 20), "frames 2/10, 1:20 left");
    EXPECT_EQ(Progress::text("frames", 10, 10, 99), "frames 10/10, 0:00 left");
}

TEST(Progress, saysNothingInAPipe) {
    testing::internal::CaptureStderr();
    Progress("frames", 3, true).update(1);
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

} // namespace
} // namespace limpid
