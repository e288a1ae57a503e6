// The reference against closed forms.
#include <numbers>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

#include "reference/Traced.h"

namespace limpid {
namespace {

constexpr double pi = std::numbers::pi;

TEST(FlatWater, isUniformAndExactAtEveryAngle) {
    for (const double degrees : {0.0, 30.0, 60.0, 80.0}) {
        Scene scene;
        scene.lights = {scenes::sunAt(degrees)};
        scene.lights[0].irradiance = {3, 2, 1};
        scene.water.absorption = {0.5, 0.2, 0.1};
        scene.water.scattering = {0.1, 0.1, 0.0};
        scene.receivers = {scenes::floorAt(-1.2)};
        scene.caustics.mapSize = 64;
        const test::Traced traced = test::trace(scene, 160'000);
        const double angle = glm::radians(degrees), below = test::refractedAngle(angle, 1.333);
        for (std::size_t c = 0; c < 3; ++c) {
            const double extinction = scene.water.absorption[int(c)] + scene.water.scattering[int(c)];
            const double expected = scene.lights[0].irradiance[int(c)] * std::cos(angle) *
                                    test::transmittance(angle, 1.333) *
                                    std::exp(-extinction * 1.2 / std::cos(below));
            const glm::ivec2 size = traced.size();
            double error = 0;
            for (int y = 0; y < size.y; ++y)
                for (int x = 0; x < size.x; ++x) {
                    const double found = double(traced.map().irradiance[3 * std::size_t(size.x * y + x) + c]);
                    error += std::abs(found - expected) / (size.x * size.y);
                    // A float holds 6e-8 of a value; all else is double. Cells on the floor's edge go to
                    // plain photons, which are noise; a cell is half of a texel.
                    if (std::min({x, y, size.x - 1 - x, size.y - 1 - y}) < 2) continue;
                    ASSERT_NEAR(found, expected, 1e-6 * expected)
                        << degrees << " degrees, " << x << ", " << y;
                }
            EXPECT_LT(error, 0.001 * expected) << degrees << " degrees";
        }
        EXPECT_LT(traced.map().standardError, 0.001);
    }
}

/// Texel means of one cosine wave's light, by rays so dense that each footprint is a thousandth of a texel.
std::vector<double> cosineTruth(int texels, double size, double depth, bool fresnel) {
    std::vector<double> mean(std::size_t(texels), 0.0);
    const double texel = size / texels, reach = 0.5 * size + 0.2;
    const int rays = 1000 * texels;
    const double step = 2 * reach / rays;
    const auto land = [&](int i) { return test::Landing(-reach + i * step, 0.004, 10 * pi, depth, 1.333); };
    test::Landing left = land(0);
    for (int i = 0; i < rays; ++i) {
        const test::Landing right = land(i + 1);
        const double flux = step * (fresnel ? 0.5 * (left.transmittance + right.transmittance) : 1);
        const double low = (std::min(left.place, right.place) + 0.5 * size) / texel;
        const double high = (std::max(left.place, right.place) + 0.5 * size) / texel;
        for (int t = std::max(int(std::floor(low)), 0); t <= std::min(int(std::floor(high)), texels - 1);
             ++t) {
            const double share =
                high > low ? (std::min(high, t + 1.0) - std::max(low, double(t))) / (high - low) : 1;
            mean[std::size_t(t)] += flux * share / texel;
        }
        left = right;
    }
    return mean;
}

TEST(CosineWave, meansOfTexelsAreRight) {
    // A metre at 512 texels, and a strip of it: along the wave's crests nothing changes.
    const Scene scene = test::waveOverFloor(WaveType::Cosine, 1, {1, 1.0 / 32}, 512);
    const test::Traced traced = test::trace(scene, 600'000);
    ASSERT_EQ(traced.size(), glm::ivec2(512, 16));

    const std::vector<double> plain = cosineTruth(512, 1, 1, false);
    EXPECT_NEAR(*std::min_element(plain.begin(), plain.end()), 0.504, 0.001) << "the figures of physics.md";
    EXPECT_NEAR(*std::max_element(plain.begin(), plain.end()), 17.4, 0.1);

    const std::vector<double> truth = cosineTruth(512, 1, 1, true);
    double error = 0, sum = 0;
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 512; ++x) {
            error += std::abs(traced.irradiance(0, x, y) - truth[std::size_t(x)]);
            sum += truth[std::size_t(x)];
        }
    printf("cosine wave: nMAE %.4f %%, standard error %.4f %%\n", 100 * error / sum,
           100 * traced.map().standardError);
    EXPECT_LT(error / sum, 0.003);
}

TEST(CircularWave, isRightAllAround) {
    // Shallow enough that no two rings cross: then the light at a distance is what its own ring brings,
    // E = T r dr / (r' dr').
    constexpr double depth = 0.4, k = 10 * pi;
    const Scene scene = test::waveOverFloor(WaveType::Circular, depth, {0.5, 0.5}, 128);
    const test::Traced traced = test::trace(scene, 2'000'000);
    const auto land = [&](double r) { return test::Landing(r, 0.004, k, depth, 1.333); };
    const auto density = [&](double place) {
        double low = 0, high = 1;
        for (int i = 0; i < 50; ++i) {
            const double middle = 0.5 * (low + high);
            (land(middle).place < place ? low : high) = middle;
        }
        constexpr double d = 1e-6;
        const double widening = (land(low + d).place - land(low - d).place) / (2 * d);
        return land(low).transmittance * low / (place * widening);
    };
    double error = 0, sum = 0;
    for (int y = 0; y < 128; ++y)
        for (int x = 0; x < 128; ++x) {
            double mean = 0;
            for (int i = 0; i < 9; ++i) {
                const glm::dvec2 at(x + (i % 3 + 0.5) / 3 - 64, y + (i / 3 + 0.5) / 3 - 64);
                mean += density(glm::length(at) * 0.5 / 128) / 9;
            }
            error += std::abs(traced.irradiance(0, x, y) - mean);
            sum += mean;
        }
    printf("circular wave: nMAE %.4f %%, standard error %.4f %%\n", 100 * error / sum,
           100 * traced.map().standardError);
    EXPECT_LT(error / sum, 0.003);
}

class SphereTest : public testing::Test {
  protected:
    static constexpr double depth = 1.5, radius = 0.3;
    const double angle = glm::radians(40.0), below = test::refractedAngle(angle, 1.333);
    const glm::dvec3 light{std::sin(below), -std::cos(below), 0};
    /// W/m² across the light, below the surface.
    const double beam = std::cos(angle) * test::transmittance(angle, 1.333) / std::cos(below);

    Scene scene(bool withSphere) const {
        Scene result;
        result.lights = {scenes::sunAt(40)};
        result.receivers = {scenes::floorAt(-depth, 3)};
        if (withSphere)
            result.receivers.push_back(
                scenes::shape("sphere", makeSphere(radius, glm::vec3(0.8f)), {0, -0.8, 0}));
        result.caustics.mapSize = 256;
        return result;
    }
    /// What the sphere's flat faces hide, across the light, m².
    double crossSection() const {
        const Mesh mesh = makeSphere(radius, glm::vec3(1));
        double twice = 0;
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
            const glm::dvec3 a = mesh.positions[mesh.indices[i]];
            twice += 0.5 * std::abs(glm::dot(light, glm::cross(mesh.positions[mesh.indices[i + 1]] - a,
                                                               mesh.positions[mesh.indices[i + 2]] - a)));
        }
        return twice / 2;
    }
};

TEST_F(SphereTest, throwsItsShadow) {
    const test::Traced traced = test::trace(scene(true), 400'000);
    const double full = beam * std::cos(below);
    double missing = 0, texel = traced.frame(0).texel;
    glm::dvec3 middle(0);
    for (int y = 0; y < traced.size(0).y; ++y)
        for (int x = 0; x < traced.size(0).x; ++x) {
            const double lost = 1 - traced.irradiance(0, x, y) / full;
            missing += lost * texel * texel / std::cos(below);
            middle += lost * traced.position(0, x, y);
            const glm::dvec3 p = traced.position(0, x, y), from = glm::dvec3(0, -0.8, 0) - p;
            const double aside = glm::length(glm::cross(from, light));
            // The faces lie up to 0.8 % inside of the sphere, and four cells that are taken as one reach 6
            // cm.
            if (aside < 0.99 * radius - 0.06) {
                ASSERT_EQ(lost, 1) << x << ", " << y;
            }
            const bool edge = std::min({x, y, traced.size(0).x - 1 - x, traced.size(0).y - 1 - y}) < 4;
            if (aside > radius + 0.06 && !edge) {
                ASSERT_NEAR(lost, 0, 1e-6) << x << ", " << y;
            }
        }
    middle /= missing * std::cos(below) / (texel * texel);
    const double area = crossSection() / std::cos(below);
    printf("shadow: %.6f m2, expected %.6f\n", missing, area);
    EXPECT_NEAR(missing, area, 0.001 * area);
    EXPECT_NEAR(middle.x, 0.7 * std::tan(below), 0.1 * texel);
    EXPECT_NEAR(middle.z, 0, 0.1 * texel);
}

TEST_F(SphereTest, takesTheLightOfItsCrossSection) {
    const test::Traced traced = test::trace(scene(true), 400'000);
    const double taken = traced.map(1).deposited;
    EXPECT_NEAR(taken + traced.light().rejected, beam * crossSection(), 0.001 * beam * crossSection());
    EXPECT_LT(traced.light().rejected, 0.01 * taken) << "texels at the rim whose middle sees nothing";
    // On each flat face the light is the beam's times the cosine.
    const int size = traced.size(1).x;
    double error = 0, sum = 0;
    for (int y = 0; y < traced.size(1).y; ++y)
        for (int x = 0; x < size; ++x) {
            if (!traced.covered(1, x, y)) continue;
            const float* n = &traced.map(1).normal[3 * std::size_t(y * size + x)];
            const double expected = -beam * glm::dot(light, glm::dvec3(n[0], n[1], n[2]));
            error += std::abs(traced.irradiance(1, x, y) - expected);
            sum += expected;
        }
    printf("sphere: nMAE %.4f %%, standard error %.4f %%\n", 100 * error / sum,
           100 * traced.map(1).standardError);
    // Texels that a face's edge crosses hold the light of two: a face is 8 texels wide, and its neighbour's
    // cosine differs by up to 0.1 of it.
    EXPECT_LT(error / sum, 0.01);
}

} // namespace
} // namespace limpid
