#include <array>
#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "core/Optics.h"

namespace limpid {
namespace {

using Polygon = std::vector<glm::dvec2>;

double areaOf(const Polygon& p) {
    double sum = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const glm::dvec2 &a = p[i], &b = p[(i + 1) % p.size()];
        sum += 0.5 * (a.x * b.y - a.y * b.x);
    }
    return std::abs(sum);
}

/// Sutherland and Hodgman's clip, in double: another way to the same area.
Polygon clipped(Polygon polygon) {
    const std::array<glm::dvec3, 4> sides{glm::dvec3(1, 0, 0), {-1, 0, 1}, {0, 1, 0}, {0, -1, 1}};
    for (const glm::dvec3& side : sides) {
        const auto inside = [&](const glm::dvec2& p) { return side.x * p.x + side.y * p.y + side.z; };
        Polygon kept;
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const glm::dvec2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
            const double da = inside(a), db = inside(b);
            if (da >= 0) kept.push_back(a);
            if ((da < 0) != (db < 0)) kept.push_back(a + (b - a) * (da / (da - db)));
        }
        polygon = kept;
    }
    return polygon;
}

double inRectangle(const std::array<glm::vec2, 3>& t, const glm::vec2& low, const glm::vec2& high) {
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i)
        sum += double(shader::edgeInRectangle(shader::beamEdge(t[i], t[(i + 1) % 3]), low, high));
    return std::abs(sum);
}

double inSquare(const std::array<glm::vec2, 3>& t) {
    return inRectangle(t, glm::vec2(0), glm::vec2(1));
}

TEST(BeamAreaTest, agreesWithAClippedPolygon) {
    std::mt19937 random(7);
    for (const float size : {0.05f, 0.5f, 2.0f, 8.0f}) {
        std::uniform_real_distribution<float> place(0.5f - size, 0.5f + size);
        for (int i = 0; i < 5000; ++i) {
            const std::array<glm::vec2, 3> t{glm::vec2(place(random), place(random)),
                                             {place(random), place(random)},
                                             {place(random), place(random)}};
            const double exact = areaOf(clipped({t[0], t[1], t[2]}));
            // Heights of up to `size` carry half a unit in the last place each, over a handful of operations.
            ASSERT_NEAR(inSquare(t), exact, 1e-6 * (1 + size)) << size;
        }
    }
}

TEST(BeamAreaTest, edgesAlongTheGridCountOnce) {
    // A square made of two triangles, its corners on the grid and on texel middles.
    for (const float at : {-1.0f, -0.5f, 0.0f, 0.5f})
        for (const float size : {0.5f, 1.0f, 2.0f}) {
            const glm::vec2 a(at), b(at + size, at), c(at + size), d(at, at + size);
            const double overlap =
                std::max(0.0, std::min(1.0, double(at + size)) - std::max(0.0, double(at)));
            EXPECT_NEAR(inSquare({a, b, c}) + inSquare({a, c, d}), overlap * overlap, 1e-6);
        }
}

TEST(BeamAreaTest, texelsShareAllOfABeam) {
    std::mt19937 random(11);
    std::uniform_real_distribution<float> place(0, 6);
    for (int i = 0; i < 200; ++i) {
        const std::array<glm::vec2, 3> t{glm::vec2(place(random), place(random)),
                                         {place(random), place(random)},
                                         {place(random), place(random)}};
        double sum = 0;
        for (int y = 0; y < 6; ++y)
            for (int x = 0; x < 6; ++x)
                sum += inSquare({t[0] - glm::vec2(x, y), t[1] - glm::vec2(x, y), t[2] - glm::vec2(x, y)});
        const double whole = 0.5 * std::abs(double(shader::cross2(t[1] - t[0], t[2] - t[0])));
        EXPECT_NEAR(sum, whole, 36 * 6e-7 * 7);
    }
}

TEST(BeamAreaTest, aTexelInsideALargeBeamIsWhole) {
    std::mt19937 random(17);
    std::uniform_real_distribution<float> jitter(-1, 1);
    for (int i = 0; i < 1000; ++i) {
        const std::array<glm::vec2, 3> t{glm::vec2(-300 + jitter(random), -200 + jitter(random)),
                                         {700 + jitter(random), -250 + jitter(random)},
                                         {100 + jitter(random), 600 + jitter(random)}};
        // Edges of a thousand texels err by their length times a float's rounding, three of them.
        EXPECT_NEAR(inSquare(t), 1, 3 * 1000 * 6e-8);
    }
}

TEST(BeamAreaTest, aBeamInFocusIsAsExactAsAWideOne) {
    // All of a small triangle around the corner of four texels, each cut down to the triangle's bounds.
    std::mt19937 random(13);
    std::uniform_real_distribution<float> unit(-1, 1);
    for (const float size : {1e-3f, 1e-5f})
        for (int i = 0; i < 1000; ++i) {
            std::array<glm::vec2, 3> t{glm::vec2(0), size * glm::vec2(unit(random), unit(random)),
                                       size * glm::vec2(unit(random), unit(random))};
            const glm::vec2 cross = 0.4f * (t[1] + t[2]); // where the four texels meet
            const glm::vec2 least = glm::min(t[0], glm::min(t[1], t[2]));
            const glm::vec2 most = glm::max(t[0], glm::max(t[1], t[2]));
            double sum = 0;
            for (int k = 0; k < 4; ++k) {
                const glm::bvec2 right(k % 2 == 1, k / 2 == 1);
                sum += inRectangle(t, glm::mix(least, cross, right), glm::mix(cross, most, right));
            }
            const double whole = 0.5 * std::abs(double(shader::cross2(t[1], t[2])));
            EXPECT_NEAR(sum, whole, 4e-6 * double(size) * double(size));
        }
}

TEST(BeamAreaTest, aLineHasNoArea) {
    EXPECT_EQ(inSquare({glm::vec2(0.2f, 0.3f), {0.2f, 0.3f}, {0.2f, 0.3f}}), 0);
    EXPECT_NEAR(inSquare({glm::vec2(0.0f, 0.5f), {1.0f, 0.5f}, {0.5f, 0.5f}}), 0, 1e-7);
    EXPECT_NEAR(inSquare({glm::vec2(0.5f, -3.0f), {0.5f, 4.0f}, {0.5f, 0.1f}}), 0, 1e-7);
}

} // namespace
} // namespace limpid
