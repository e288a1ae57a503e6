#include "core/OrientedBox.h"

#include <cmath>

#include <gtest/gtest.h>

namespace limpid {
namespace {

std::vector<glm::dvec3> corners(const glm::dvec3& size, double turn) {
    std::vector<glm::dvec3> points;
    for (int i = 0; i < 8; ++i) {
        const glm::dvec3 p = 0.5 * size * glm::dvec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
        points.emplace_back(p.x * std::cos(turn) - p.z * std::sin(turn), p.y,
                            p.x * std::sin(turn) + p.z * std::cos(turn));
    }
    return points;
}

TEST(TightBox, findsTheTurnOfABox) {
    for (const double turn : {0.0, 0.3, 1.2}) {
        const OrientedBox box = tightBox(corners({3, 2, 1}, turn), {0, -1, 0});
        EXPECT_NEAR(box.extent.x * box.extent.y, 3.0, 1e-9) << "footprint at turn " << turn;
        EXPECT_NEAR(box.extent.z, 2.0, 1e-12);
        EXPECT_NEAR(glm::length(box.center()), 0, 1e-12);
    }
}

TEST(TightBox, isRightHandedAndHoldsItsPoints) {
    const auto points = corners({1, 0.4, 2}, 0.7);
    for (const glm::dvec3& light :
         {glm::dvec3(0, -1, 0), glm::dvec3(0.6, -0.8, 0), glm::dvec3(-0.3, -0.5, 0.7)}) {
        const OrientedBox box = tightBox(points, light);
        EXPECT_LT(glm::distance(glm::cross(box.u, box.w), box.t), 1e-12);
        EXPECT_LT(glm::distance(box.t, glm::normalize(light)), 1e-12);
        for (const glm::dvec3& p : points) {
            const glm::dvec3 q = box.local(p);
            for (int c = 0; c < 3; ++c) {
                EXPECT_GE(q[c], -1e-9);
                EXPECT_LE(q[c], box.extent[c] + 1e-9);
            }
            EXPECT_LT(glm::distance(box.point(q), p), 1e-12);
        }
    }
}

TEST(TightBox, goesRightAlongXUnderAVerticalLight) {
    const OrientedBox box = tightBox(corners({2, 0, 2}, 0), {0, -1, 0});
    EXPECT_LT(glm::distance(box.u, glm::dvec3(1, 0, 0)), 1e-12);
    EXPECT_LT(glm::distance(box.w, glm::dvec3(0, 0, 1)), 1e-12);
}

TEST(TexelFrame, hasSquareTexelsAndNoFlatBox) {
    const TexelFrame frame = texelFrame(tightBox(corners({3, 0, 1}, 0.2), {0, -1, 0}), 300);
    EXPECT_EQ(std::max(frame.size.x, frame.size.y), 300);
    EXPECT_EQ(std::min(frame.size.x, frame.size.y), 100);
    EXPECT_NEAR(frame.texel, 0.01, 1e-12);
    EXPECT_TRUE(frame.flat);
    EXPECT_NEAR(frame.box.extent.z, 3e-4, 1e-12) << "1e-4 of the longer side";
}

TEST(TexelFrame, survivesPointsLinesAndGiants) {
    for (const double size : {0.0, 1e-4, 1.0, 1e4}) {
        const TexelFrame point = texelFrame(tightBox(corners(glm::dvec3(size, 0, 0), 0), {0, -1, 0}), 64);
        EXPECT_GE(point.size.x, 1);
        EXPECT_GE(point.size.y, 1);
        EXPECT_TRUE(std::isfinite(point.texel) && point.texel > 0);
        EXPECT_GT(point.box.extent.z, 0);
    }
}

TEST(TexelFrame, mapsTheWorldToTexture) {
    const auto points = corners({1, 0.4, 2}, 0.7);
    const TexelFrame frame = texelFrame(tightBox(points, glm::normalize(glm::dvec3(0.6, -0.8, 0.1))), 128);
    const glm::dmat4 m = frame.worldToTexture();
    const glm::dvec3 center(m * glm::dvec4(frame.box.center(), 1));
    EXPECT_LT(glm::distance(center, glm::dvec3(0.5)), 1e-12);
    const glm::dvec3 corner(m * glm::dvec4(frame.box.corner, 1));
    EXPECT_LT(glm::length(corner), 1e-12);
    const glm::dvec3 deeper(m * glm::dvec4(frame.box.corner + 0.1 * frame.box.t, 1));
    EXPECT_GT(deeper.z, 0) << "the third coordinate is depth along the light";
}

TEST(ConvexHull, dropsInnerAndCollinearPoints) {
    const auto hull = convexHull({{0, 0}, {1, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 1}, {0, 0}});
    EXPECT_EQ(hull.size(), 4u);
    EXPECT_EQ(convexHull({{1, 1}, {1, 1}}).size(), 1u);
}

} // namespace
} // namespace limpid
