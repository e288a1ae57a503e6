#include "reference/WaveTile.h"

#include <cmath>

#include <gtest/gtest.h>

#include "reference/Surface.h"
#include "scene/SlowWaves.h"

namespace limpid {
namespace {

TEST(WaveTile, isTheSlowTransform) {
    const auto spectrum = phillipsSpectrum({.velocity = {3, 1}, .tile = {3, 2}, .modes = 64, .seed = 7});
    const reference::WaveTile tile(*spectrum, 12.3);
    for (int i = 0; i < 300; ++i) {
        const glm::dvec2 place = glm::dvec2(0.0437 * i - 5, std::fmod(0.731 * i, 7.0) - 3);
        const glm::dvec3 truth = test::slowWaves(*spectrum, place, 12.3), here = tile.at(place);
        EXPECT_NEAR(here.x, truth.x, 1e-6);
        EXPECT_NEAR(glm::distance(glm::dvec2(here.y, here.z), {truth.y, truth.z}), 0,
                    1e-4 * spectrum->rmsSlope);
    }
}

TEST(WaveTile, isWhereTheSceneHasIt) {
    Water water;
    Wave& wave = water.waves.emplace_back();
    wave.type = WaveType::Phillips;
    wave.spectrum = phillipsSpectrum({.modes = 16});
    wave.amplitude = 0.02;
    const reference::Surface surface(water, {1000.3, 0, -7}, 2);
    const glm::dvec3 truth = 0.02 * test::slowWaves(*wave.spectrum, {1000.5, -6.6}, 2);
    EXPECT_NEAR(surface.at({0.2, 0.4}).height, truth.x, 2e-7);
    EXPECT_LE(std::abs(truth.x), surface.highest());
    EXPECT_EQ(surface.shortest(), 1);
}

} // namespace
} // namespace limpid
