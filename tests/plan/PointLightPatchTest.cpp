#include "plan/PointLightPatch.h"

#include <cmath>

#include <gtest/gtest.h>

#include "engine/Scenes.h"

namespace limpid {
namespace {

const WaterPatch patch{{0.3, -0.2}, {4, 3}, {256, 100}, {}};

TEST(PointLightPatch, nothingWhereTheGridIsFineEnough) {
    // Quads are 0.03 m wide.
    EXPECT_FALSE(pointLightPatch(scenes::pointLightAt({0, 0.25, 0}), {}, patch));
    EXPECT_FALSE(pointLightPatch(Light{}, {}, patch));
    EXPECT_FALSE(pointLightPatch(scenes::pointLightAt({0, -0.25, 0}), {}, patch))
        << "a lamp under water has no beams";
}

TEST(PointLightPatch, noQuadIsWiderThanThePointLightSeesItTurn) {
    for (const double height : {0.1, 0.01, 0.001})
        for (const glm::dvec2 foot : {glm::dvec2(0.003, 0.002), glm::dvec2(-3, 1)}) {
            const auto fine = pointLightPatch(scenes::pointLightAt({foot.x, height, foot.y}), {}, patch);
            if (!fine) {
                // Its foot is far beside the patch.
                EXPECT_EQ(foot.x, -3);
                continue;
            }
            for (const int axis : {0, 1}) {
                const auto& lines = fine->lines[std::size_t(axis)];
                ASSERT_EQ(int(lines.size()), fine->grid[axis] + 1);
                EXPECT_EQ(lines.front(), 0);
                EXPECT_EQ(lines.back(), patch.size[axis]);
                for (std::size_t i = 1; i < lines.size(); ++i) {
                    const double low = lines[i - 1] + patch.min()[axis], high = lines[i] + patch.min()[axis];
                    const double aside = std::max({low - foot[axis], foot[axis] - high, 0.0});
                    EXPECT_LT(low, high);
                    EXPECT_LE(high - low, pointLightTurn * std::hypot(height, aside) * (1 + 1e-9));
                }
            }
        }
}

// Halving leaves quads of more than half of what is allowed, so that a factor of ten in height takes no more
// lines than 2 sides · 2 / pointLightTurn · ln 10, and those within pointLightTurn of the height.
TEST(PointLightPatch, linesGoWithTheLogarithmOfTheHeight) {
    int before = pointLightPatch(scenes::pointLightAt({0, 0.01, 0}), {}, patch)->grid.x;
    for (const double height : {1e-3, 1e-4, 1e-5}) {
        const int now = pointLightPatch(scenes::pointLightAt({0, height, 0}), {}, patch)->grid.x;
        EXPECT_GT(now, before);
        EXPECT_LE(now - before, 4 / pointLightTurn * std::log(10) + 1);
        before = now;
    }
    EXPECT_LE(pointLightPatch(scenes::pointLightAt({0, 1e-300, 0}), {}, patch)->grid.x,
              256 + 4 / pointLightTurn * std::log(0x1p16));
}

} // namespace
} // namespace limpid
