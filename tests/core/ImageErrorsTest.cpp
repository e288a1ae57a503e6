#include "core/ImageErrors.h"

#include <array>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace limpid {
namespace {

TEST(Luv, hasKnownValues) {
    const glm::dvec3 white = luvFromLinear({1, 1, 1});
    EXPECT_NEAR(white.x, 100, 1e-9);
    EXPECT_NEAR(white.y, 0, 0.02);
    EXPECT_NEAR(white.z, 0, 0.02);
    // Published Luv of the Rec. 709 primaries (e.g. Lindbloom's calculator): red 53.24, 175.01, 37.76.
    const glm::dvec3 red = luvFromLinear({1, 0, 0});
    EXPECT_NEAR(red.x, 53.24, 0.01);
    EXPECT_NEAR(red.y, 175.01, 0.05);
    EXPECT_NEAR(red.z, 37.76, 0.05);
    EXPECT_EQ(luvFromLinear({0, -1, std::numeric_limits<double>::quiet_NaN()}), glm::dvec3(0));
}

TEST(LuvDifference, isAMeanOverTheObject) {
    const std::array<float, 6> a{1, 1, 1, 0, 0, 0}, b{0, 0, 0, 0, 0, 0};
    EXPECT_EQ(luvDifference(a, a), 0);
    EXPECT_NEAR(luvDifference(a, b), 50, 0.01);
    const std::array<float, 2> first{1, 0}, none{0, 0};
    EXPECT_NEAR(luvDifference(a, b, first), 100, 0.01);
    EXPECT_EQ(luvDifference(a, b, none), 0);
}

} // namespace
} // namespace limpid
