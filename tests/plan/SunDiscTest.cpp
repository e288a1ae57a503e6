#include "plan/SunDisc.h"

#include <cmath>

#include <gtest/gtest.h>

namespace limpid {
namespace {

/// Where in the disc of a sun straight above a point of it lies, in radii.
glm::dvec2 offsetOf(const Light& point, double diameter) {
    const double radius = std::tan(0.5 * glm::radians(diameter));
    return glm::dvec2(point.direction.x, point.direction.z) / (-point.direction.y * radius);
}

TEST(SunDisc, hasTheMomentsOfAnEvenDisc) {
    Light sun;
    sun.direction = {0, -1, 0};
    sun.angularDiameter = 0.53;
    const auto points = discPoints(sun);
    ASSERT_EQ(points.size(), 4);
    glm::dvec2 mean(0);
    // Each point is a disc itself, whose variance along any axis is a quarter of its radius squared.
    double xx = 0, yy = 0, xy = 0;
    for (const Light& point : points) {
        const glm::dvec2 at = offsetOf(point, sun.angularDiameter);
        mean += 0.25 * at;
        xx += 0.25 * (at.x * at.x + 0.25 * discPointRadius * discPointRadius);
        yy += 0.25 * (at.y * at.y + 0.25 * discPointRadius * discPointRadius);
        xy += 0.25 * at.x * at.y;
        EXPECT_EQ(point.irradiance, sun.irradiance);
    }
    EXPECT_NEAR(glm::length(mean), 0, 1e-12);
    EXPECT_NEAR(xx, 0.25, 1e-12);
    EXPECT_NEAR(yy, 0.25, 1e-12);
    EXPECT_NEAR(xy, 0, 1e-12);
}

TEST(SunDisc, isOnePointForWhatHasNone) {
    Light sun;
    EXPECT_EQ(discPoints(sun).size(), 1);
    sun.angularDiameter = 0.53;
    sun.type = LightType::Point;
    EXPECT_EQ(discPoints(sun).size(), 1);
}

} // namespace
} // namespace limpid
