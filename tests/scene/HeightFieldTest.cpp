#include "scene/HeightField.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/Optics.h"

namespace limpid {
namespace {

/// Height and its derivatives by texel at (x, z), in texels from the middle of the first one.
glm::dvec3 valueAndSlope(const HeightField& field, float x, float z) {
    const glm::vec2 base(std::floor(x), std::floor(z));
    const glm::vec4 wx = shader::splineWeights(x - base.x), dx = shader::splineSlopes(x - base.x);
    const glm::vec4 wz = shader::splineWeights(z - base.y), dz = shader::splineSlopes(z - base.y);
    glm::dvec3 sum(0);
    for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 4; ++i) {
            const glm::ivec2 at = glm::ivec2(base) - 1 + glm::ivec2(i, j);
            if (at.x < 0 || at.y < 0 || at.x >= field.size.x || at.y >= field.size.y) continue;
            const float c = field.spline[std::size_t(at.y) * std::size_t(field.size.x) + std::size_t(at.x)];
            sum += c * glm::vec3(wx[i] * wz[j], dx[i] * wz[j], wx[i] * dz[j]);
        }
    return sum;
}

/// Rough on purpose: neighbours have nothing to do with each other.
std::vector<float> randomHeights(glm::ivec2 size) {
    std::vector<float> heights;
    unsigned state = 1;
    for (int i = 0; i < size.x * size.y; ++i) {
        state = state * 1664525u + 1013904223u;
        heights.push_back(float(state >> 8) / 8388608.0f - 1);
    }
    return heights;
}

TEST(Spline, weightsAddUpAndSlopesAreTheirDerivatives) {
    for (float f = 0; f <= 1; f += 0.125f) {
        const glm::vec4 w = shader::splineWeights(f), d = shader::splineSlopes(f);
        EXPECT_NEAR(w.x + w.y + w.z + w.w, 1, 1e-6f);
        EXPECT_NEAR(d.x + d.y + d.z + d.w, 0, 1e-6f);
        const glm::vec4 difference =
            (shader::splineWeights(f + 0.01f) - shader::splineWeights(f - 0.01f)) / 0.02f;
        // The weights are cubic: a central difference is off by the third derivative, at most 3, over 6,
        // times 0.01²; rounding adds 1e-5.
        for (int i = 0; i < 4; ++i)
            EXPECT_NEAR(d[i], difference[i], 7e-5f);
    }
}

TEST(HeightField, goesThroughItsHeights) {
    const glm::ivec2 size(40, 23);
    const std::vector<float> heights = randomHeights(size);
    const HeightField field = makeHeightField(size, heights, {0, 0});
    for (int z = 2; z < size.y - 2; ++z)
        for (int x = 2; x < size.x - 2; ++x)
            EXPECT_NEAR(valueAndSlope(field, float(x), float(z)).x,
                        double(heights[std::size_t(z * size.x + x)]), 2e-6);
}

TEST(HeightField, endsSmoothlyAtItsEdge) {
    const glm::ivec2 size(16, 12);
    const HeightField field = makeHeightField(size, std::vector<float>(16 * 12, 1.0f), {0, 0});
    for (float z = -3; z < 15; z += 0.25f)
        for (const float x : {-2.0f, -0.5f, 0.0f, 15.0f, 15.5f, 18.0f})
            EXPECT_EQ(valueAndSlope(field, x, z), glm::dvec3(0)) << x << ' ' << z;
}

TEST(HeightField, fadesAsFarAsItIsTold) {
    const glm::ivec2 size(64, 64);
    const HeightField field = makeHeightField(size, std::vector<float>(64 * 64, 1.0f), {16, 8});
    const auto height = [&](float x, float z) { return valueAndSlope(field, x, z).x; };
    EXPECT_NEAR(height(31, 31), 1, 1e-5);
    EXPECT_NEAR(height(16, 31), 1, 1e-3);
    EXPECT_NEAR(height(7.5f, 31), 0.5, 1e-3) << "half-way through the fade of 16 texels from the edge, -0.5";
    EXPECT_NEAR(height(31, 3.5f), 0.5, 1e-3);
    // 15/8 over the fade, and up to a tenth more where few texels have to do for it.
    EXPECT_LT(field.steepest.x, 1.1 * 1.875 / 16);
    EXPECT_LT(field.steepest.y, 1.1 * 1.875 / 8);
}

TEST(HeightField, keepsItsBounds) {
    const glm::ivec2 size(32, 32);
    const HeightField field = makeHeightField(size, randomHeights(size), {4, 4});
    double highest = 0;
    glm::dvec2 steepest(0);
    for (float z = -1; z < 33; z += 0.1f)
        for (float x = -1; x < 33; x += 0.1f) {
            const glm::dvec3 v = glm::abs(valueAndSlope(field, x, z));
            highest = std::max(highest, v.x);
            steepest = glm::max(steepest, glm::dvec2(v.y, v.z));
        }
    EXPECT_LE(highest, field.highest + 1e-6);
    EXPECT_LE(steepest.x, field.steepest.x + 1e-6);
    EXPECT_LE(steepest.y, field.steepest.y + 1e-6);
    EXPECT_GT(highest, 0.2 * field.highest) << "and they are not idle";
    EXPECT_GT(steepest.x, 0.2 * field.steepest.x);
}

} // namespace
} // namespace limpid
