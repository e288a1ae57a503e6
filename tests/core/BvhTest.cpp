// A bounding volume hierarchy holds every box once, within the bounds of all nodes above it, and is walked
// without a stack.
#include "core/Bvh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace limpid {
namespace {

bool holds(const BvhNode& node, const Box3f& box) {
    return glm::all(glm::lessThanEqual(node.low, box.low)) &&
           glm::all(glm::greaterThanEqual(node.high, box.high));
}

bool overlap(const Box3f& a, const glm::vec3& low, const glm::vec3& high) {
    return glm::all(glm::lessThanEqual(a.low, high)) && glm::all(glm::greaterThanEqual(a.high, low));
}

/// Boxes that a walk by `next` finds, as the shaders walk it.
std::vector<std::uint32_t> found(const Bvh& bvh, std::span<const Box3f> boxes, const Box3f& where) {
    std::vector<std::uint32_t> out;
    for (std::size_t i = 0; i < bvh.nodes.size();) {
        const BvhNode& node = bvh.nodes[i];
        if (!overlap(where, node.low, node.high)) {
            i = std::size_t(node.next);
            continue;
        }
        for (int k = node.items >> 3; k < (node.items >> 3) + (node.items & 7); ++k)
            if (const std::uint32_t box = bvh.order[std::size_t(k)];
                overlap(where, boxes[box].low, boxes[box].high))
                out.push_back(box);
        ++i;
    }
    std::sort(out.begin(), out.end());
    return out;
}

std::vector<Box3f> randomBoxes(int count, float size, float spread) {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> place(0, spread), extent(0, size);
    std::vector<Box3f> boxes;
    for (int i = 0; i < count; ++i) {
        const glm::vec3 at(place(random), place(random), place(random));
        boxes.push_back({at, at + glm::vec3(extent(random), extent(random), extent(random))});
    }
    return boxes;
}

TEST(Bvh, holdsEveryBoxOnceWithinItsNodes) {
    for (const int count : {1, 4, 5, 1000}) {
        const auto boxes = randomBoxes(count, 0.1f, 1);
        const Bvh bvh = buildBvh(boxes);
        auto order = bvh.order;
        std::sort(order.begin(), order.end());
        for (std::uint32_t i = 0; i < order.size(); ++i)
            EXPECT_EQ(order[i], i);
        for (std::size_t n = 0; n < bvh.nodes.size(); ++n)
            for (std::size_t m = n; m < std::size_t(bvh.nodes[n].next); ++m)
                for (int k = bvh.nodes[m].items >> 3;
                     k < (bvh.nodes[m].items >> 3) + (bvh.nodes[m].items & 7); ++k)
                    EXPECT_TRUE(holds(bvh.nodes[n], boxes[bvh.order[std::size_t(k)]]));
    }
}

TEST(Bvh, aWalkFindsWhatOverlaps) {
    const auto boxes = randomBoxes(2000, 0.05f, 1);
    const Bvh bvh = buildBvh(boxes);
    for (const Box3f& where : randomBoxes(50, 0.2f, 1)) {
        std::vector<std::uint32_t> expected;
        for (std::uint32_t i = 0; i < boxes.size(); ++i)
            if (overlap(where, boxes[i].low, boxes[i].high)) expected.push_back(i);
        EXPECT_EQ(found(bvh, boxes, where), expected);
    }
}

TEST(Bvh, takesBoxesThatNothingTellsApart) {
    EXPECT_TRUE(buildBvh({}).nodes.empty());
    const std::vector<Box3f> same(100, Box3f{{1, 2, 3}, {1, 2, 3}});
    const Bvh bvh = buildBvh(same);
    EXPECT_EQ(found(bvh, same, same[0]).size(), 100u);
    EXPECT_LT(bvh.nodes.size(), 100u);
}

TEST(Bvh, visitsFewNodes) {
    const auto boxes = randomBoxes(20000, 0.01f, 1);
    const Bvh bvh = buildBvh(boxes);
    int visited = 0;
    const Box3f where{{0.5f, 0.5f, 0}, {0.5f, 0.5f, 1}};
    for (std::size_t i = 0; i < bvh.nodes.size(); ++visited)
        i = overlap(where, bvh.nodes[i].low, bvh.nodes[i].high) ? i + 1 : std::size_t(bvh.nodes[i].next);
    EXPECT_LT(visited, 400);
}

} // namespace
} // namespace limpid
