#include "levelmap/ReferencePlanes.h"

#include <gmock/gmock.h>

namespace limpid {
namespace {

using ::testing::ElementsAre;
using ::testing::Field;

TEST(UniformPlanes, includeBothFaces) {
    const auto planes = uniformPlanes(2.0, 5);
    ASSERT_EQ(planes.size(), 5u);
    EXPECT_EQ(planes.front().depth, 0);
    EXPECT_EQ(planes[1].depth, 0.5);
    EXPECT_EQ(planes.back().depth, 2);
    EXPECT_EQ(uniformPlanes(2.0, 1).front().depth, 1);
}

TEST(OccupiedPlanes, keepIndexAndDepthOfThoseWithTexels) {
    const std::vector<std::uint32_t> histogram{7, 0, 0, 1, 0};
    const auto planes = occupiedPlanes(4.0, histogram);
    ASSERT_EQ(planes.size(), 2u);
    EXPECT_EQ(planes[0].index, 0);
    EXPECT_EQ(planes[1].index, 3);
    EXPECT_EQ(planes[1].depth, 3);
    EXPECT_TRUE(occupiedPlanes(4.0, std::vector<std::uint32_t>(6, 0)).empty());
}

TEST(SubBoxes, areTheRunsOfValidLevels) {
    // Thesis figure 4-19: levels 4 and 5 of 10 are empty.
    const std::vector<std::uint32_t> histogram{3, 9, 4, 0, 0, 5, 1, 1, 1, 2};
    const auto boxes = subBoxes(2.0, histogram, 0.05);
    ASSERT_EQ(boxes.size(), 2u);
    EXPECT_FLOAT_EQ(boxes[0].top, 0);
    EXPECT_FLOAT_EQ(boxes[0].height, 0.6f) << "eq. 4-21: h · 3/10";
    EXPECT_EQ(boxes[0].planeCount, 3) << "eq. 4-22: 0.3 / (2 · 0.05)";
    EXPECT_FLOAT_EQ(boxes[1].top, 1);
    EXPECT_FLOAT_EQ(boxes[1].height, 1);
    EXPECT_EQ(boxes[1].firstPlane, 3);
    EXPECT_EQ(boxes[1].planeCount, 5);
    const auto planes = planesOf(boxes);
    ASSERT_EQ(planes.size(), 8u);
    EXPECT_FLOAT_EQ(float(planes[2].depth), 0.6f) << "both faces of the sub-box";
    EXPECT_FLOAT_EQ(float(planes[3].depth), 1.0f);
    EXPECT_FLOAT_EQ(float(planes[7].depth), 2.0f);
}

TEST(SubBoxes, getAtLeastOnePlaneInTheirMiddle) {
    const std::vector<std::uint32_t> histogram{0, 1, 0, 0};
    const auto planes = planesOf(subBoxes(4.0, histogram, 0.5));
    ASSERT_EQ(planes.size(), 1u);
    EXPECT_EQ(planes[0].index, 0);
    EXPECT_FLOAT_EQ(float(planes[0].depth), 1.5f);
    EXPECT_TRUE(subBoxes(4.0, std::vector<std::uint32_t>(4, 0), 0.1).empty());
}

} // namespace
} // namespace limpid
