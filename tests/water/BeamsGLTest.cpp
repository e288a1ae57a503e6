#include "water/Beams.h"

#include <cmath>
#include <numeric>

#include "core/Optics.h"
#include "engine/Scenes.h"
#include "gl/GLFixture.h"
#include "plan/WaveTerms.h"

namespace limpid {
namespace {

class BeamsGLTest : public GLTest {
  protected:
    struct Traced {
        std::vector<glm::vec4> positions, normals, origins, directions;
        std::vector<float> flux;
        std::vector<std::uint32_t> indices;
        double sum = 0;
    };

    static Traced trace(const Water& water, const WaterPatch& patch, const Light& light,
                        const glm::dvec3& origin = {}) {
        WaterSurface surface(context());
        surface.update(water, patch, origin, 0);
        BeamTracer tracer(context());
        Beams beams;
        tracer.prepare(beams, surface.mesh(), light, water, lightFrame(light, water, origin));
        tracer.trace(beams, surface.mesh(), nullptr);
        const auto vertices = std::size_t(surface.mesh().vertexCount),
                   triangles = std::size_t(beams.triangleCount);
        Traced traced{surface.mesh().positions.read<glm::vec4>(vertices),
                      surface.mesh().normals.read<glm::vec4>(vertices),
                      beams.origins.read<glm::vec4>(vertices),
                      beams.directions.read<glm::vec4>(vertices),
                      beams.flux.read<float>(triangles),
                      surface.mesh().indices.read<std::uint32_t>(3 * triangles),
                      0};
        traced.sum = std::accumulate(traced.flux.begin(), traced.flux.end(), 0.0);
        return traced;
    }

    static WaterPatch patchOf(glm::dvec2 size, glm::ivec2 grid) { return {{0.1, -0.2}, size, grid}; }
};

TEST_F(BeamsGLTest, surfaceIsTheSumOfItsWaves) {
    Water water;
    water.level = 0.3;
    water.waves = {scenes::cosine(0.02, 0.5, {1, 2}), scenes::noise(0.03, 0.4)};
    const WaterPatch patch = patchOf({3, 2}, {24, 16});
    const glm::dvec3 origin(0.5, 1.0, -0.25);
    const Traced traced = trace(water, patch, scenes::sunAt(20), origin);
    const auto terms = waveTerms(water, origin, 0);
    for (std::size_t i = 0; i < traced.positions.size(); ++i) {
        const glm::vec3 p = traced.positions[i];
        glm::vec3 sum(0);
        for (const gpu::WaveTerm& t : terms)
            sum += shader::waveHeightAndSlope({t.shape, t.place, t.kind, t.cell}, {p.x, p.z});
        EXPECT_NEAR(p.y, 0.3f - 1.0f + sum.x, 2e-6f);
        EXPECT_LT(glm::distance(glm::vec3(traced.normals[i]), glm::normalize(glm::vec3(-sum.y, 1, -sum.z))),
                  3e-5f);
    }
    EXPECT_NEAR(double(traced.positions.front().x), patch.min().x - origin.x, 1e-6);
    EXPECT_NEAR(double(traced.positions.back().z), patch.min().y + patch.size.y - origin.z, 1e-6);
}

TEST_F(BeamsGLTest, trianglesFaceUpAndTileThePatch) {
    const Traced traced = trace(Water{}, patchOf({3, 2}, {5, 4}), scenes::sunAt(0));
    double area = 0;
    for (std::size_t i = 0; i < traced.indices.size(); i += 3) {
        const glm::dvec3 a(traced.positions[traced.indices[i]]), b(traced.positions[traced.indices[i + 1]]),
            c(traced.positions[traced.indices[i + 2]]);
        const double up = 0.5 * glm::cross(b - a, c - a).y;
        EXPECT_GT(up, 0);
        area += up;
    }
    EXPECT_NEAR(area, 6, 1e-5);
}

TEST_F(BeamsGLTest, raysFollowSnellAndFresnel) {
    Water water;
    water.waves = {scenes::cosine(0.02, 0.5, {1, 2})};
    const Light sun = scenes::sunAt(60);
    const Traced traced = trace(water, patchOf({2, 2}, {16, 16}), sun);
    for (std::size_t i = 0; i < traced.origins.size(); ++i) {
        const glm::dvec3 n = glm::normalize(glm::dvec3(traced.normals[i]));
        EXPECT_LT(glm::distance(glm::dvec3(traced.directions[i]),
                                optics::refractDirection(sun.direction, n, 1 / 1.333)),
                  2e-6);
        EXPECT_NEAR(double(traced.origins[i].w),
                    optics::fresnelTransmittance(-glm::dot(sun.direction, n), 1 / 1.333), 2e-6);
    }
}

TEST_F(BeamsGLTest, flatWaterTakesTheProjectedArea) {
    for (const double degrees : {0.0, 30.0, 60.0, 80.0}) {
        const double cosine = std::cos(glm::radians(degrees));
        const Traced traced = trace(Water{}, patchOf({3, 2}, {32, 32}), scenes::sunAt(degrees));
        EXPECT_NEAR(traced.sum / (6 * cosine * optics::fresnelTransmittance(cosine, 1 / 1.333)), 1, 2e-6)
            << degrees;
    }
}

TEST_F(BeamsGLTest, wavesTakeNoMoreThanTheFlatPatch) {
    // The projected area of a closed sheet over the same outline is the outline's; only crests that shade
    // troughs and Fresnel's law change it, and a gentle surface under a high sun has neither to speak of.
    Water water;
    water.waves = {scenes::cosine(0.004, 0.5, {1, 0})};
    const double flat = trace(Water{}, patchOf({2, 2}, {64, 64}), scenes::sunAt(0)).sum;
    EXPECT_NEAR(trace(water, patchOf({2, 2}, {64, 64}), scenes::sunAt(0)).sum / flat, 1, 1e-4);
}

TEST_F(BeamsGLTest, aPointLightGivesItsSolidAngle) {
    // IOR 1: nothing is reflected, so the sum is the patch's solid angle: 4 asin(a² / (a² + h²))... for a
    // square of half side a under a point light at height h: 4 asin(a² / (a² + h²)).
    // Drivers are not asked for small angles: one has them 2e-5 low.
    Water water;
    water.ior = 1;
    Light pointLight;
    pointLight.type = LightType::Point;
    for (const double height : {0.001, 0.1, 2.0}) {
        pointLight.position = {0.1, height, -0.2};
        const double expected = 4 * std::asin(1 / (1 + height * height));
        EXPECT_NEAR(trace(water, patchOf({2, 2}, {64, 64}), pointLight).sum, expected, 3e-6 * expected)
            << height;
    }
}

Light spotAt(double inner, double outer, double tilt) {
    Light spot;
    spot.type = LightType::Point;
    spot.position = {0.1, 1, -0.2};
    spot.direction = {2 * std::sin(glm::radians(tilt)), -2 * std::cos(glm::radians(tilt)), 0};
    spot.innerCone = inner;
    spot.outerCone = outer;
    return spot;
}

// Around its axis a spot gives 2π ∫ share T(cos) d(cos) times its intensity. The patch holds all of it. A
// triangle takes the mean of the share at 16 places and of T at its corners. The share is a parabola that
// ends in a kink; over a quad of s = 3/192 m the mean errs by s²/24 of the second derivative, which is about
// 2 / (half-width of the edge)²: 7e-4 of the flux within the edge for 10° at 1 m. Half a percent where the
// edge is sharp as a quad.
TEST_F(BeamsGLTest, aSpotGivesTheIntegralOfItsCone) {
    const auto patch = patchOf({3, 3}, {192, 192});
    for (const auto& [inner, outer] : {std::pair(0.0, 40.0), std::pair(20.0, 40.0), std::pair(30.0, 31.0)}) {
        const double cosInner = std::cos(glm::radians(inner)), cosOuter = std::cos(glm::radians(outer));
        double expected = 0;
        constexpr int steps = 100000;
        for (int i = 0; i < steps; ++i) {
            const double cosine = cosOuter + (1 - cosOuter) * (i + 0.5) / steps;
            expected += 2 * M_PI * (1 - cosOuter) / steps * optics::coneShare(cosine, cosInner, cosOuter) *
                        optics::fresnelTransmittance(cosine, 1 / 1.333);
        }
        const double bound = outer - inner < 5 ? 5e-3 : 7e-4;
        EXPECT_NEAR(trace(Water{}, patch, spotAt(inner, outer, 0)).sum / expected, 1, bound) << inner;
    }
}

TEST_F(BeamsGLTest, aTiltedSpotGivesItsClosedForm) {
    // IOR 1: 2π ((1 - inner) + (inner - outer) / 3) of the cosines.
    Water water;
    water.ior = 1;
    const double cosInner = std::cos(glm::radians(10.0)), cosOuter = std::cos(glm::radians(25.0));
    const double expected = 2 * M_PI * (1 - cosInner + (cosInner - cosOuter) / 3);
    WaterPatch patch{{0.7, -0.2}, {3, 3}, {192, 192}};
    EXPECT_NEAR(trace(water, patch, spotAt(10, 25, 25)).sum / expected, 1, 7e-4);
}

TEST_F(BeamsGLTest, outsideOfItsConeASpotGivesNothing) {
    const Light spot = spotAt(10, 25, 25);
    const Traced traced = trace(Water{}, patchOf({3, 3}, {64, 64}), spot);
    const glm::dvec3 axis = glm::normalize(spot.direction);
    int dark = 0, lit = 0;
    for (std::size_t i = 0; i < traced.flux.size(); ++i) {
        double nearest = -1;
        for (std::size_t c = 0; c < 3; ++c) {
            const glm::dvec3 corner(traced.positions[traced.indices[3 * i + c]]);
            nearest = std::max(nearest, glm::dot(glm::normalize(corner - spot.position), axis));
        }
        // A quad of 3/64 m from 1 m away is 2.7° wide at most.
        if (nearest > std::cos(glm::radians(25.0 + 2.7))) {
            lit += traced.flux[i] > 0;
            continue;
        }
        ++dark;
        EXPECT_EQ(traced.flux[i], 0);
    }
    EXPECT_GT(dark, 4000);
    EXPECT_GT(lit, 500);
    Light upward = spot;
    upward.direction = {0, 1, 0};
    EXPECT_FALSE(entersWater(upward, Water{}));
    EXPECT_TRUE(entersWater(spot, Water{}));
}

TEST_F(BeamsGLTest, aLowSunLosesTheBacksOfWaves) {
    Water water;
    water.waves = {scenes::cosine(0.05, 0.5, {1, 0})};
    const Traced traced = trace(water, patchOf({2, 2}, {64, 64}), scenes::sunAt(88));
    EXPECT_TRUE(std::any_of(traced.flux.begin(), traced.flux.end(), [](float f) { return f == 0; }));
    for (const float f : traced.flux)
        EXPECT_TRUE(std::isfinite(f) && f >= 0);
}

} // namespace
} // namespace limpid
