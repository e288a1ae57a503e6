#include "plan/WaveTerms.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/Optics.h"

namespace limpid {
namespace {

shader::WaveTerm toShader(const gpu::WaveTerm& data) {
    return {data.shape, data.place, data.kind, data.cell};
}

glm::dvec3 heightAndSlope(const Wave& wave, const glm::vec2& xz, double time = 0,
                          const glm::dvec3& origin = {}) {
    Water water;
    water.waves = {wave};
    return shader::waveHeightAndSlope(toShader(waveTerms(water, origin, time)[0]), xz);
}

Wave waveOf(WaveType type) {
    Wave wave;
    wave.type = type;
    wave.amplitude = 0.05;
    wave.wavelength = 0.8;
    wave.direction = {3, 4};
    wave.center = {0.2, -0.3};
    wave.speed = 0.7;
    wave.phase = 25;
    wave.octaves = 3;
    wave.seed = 5;
    return wave;
}

TEST(Waves, cosineIsTheContractsFormula) {
    const Wave wave = waveOf(WaveType::Cosine);
    const double s = 0.6 * 0.31 + 0.8 * -0.12 - 0.7 * 2.5;
    const double angle = 2 * M_PI / 0.8 * s + glm::radians(25.0);
    EXPECT_NEAR(heightAndSlope(wave, {0.31f, -0.12f}, 2.5).x, 0.05 * std::cos(angle), 1e-6);
}

TEST(Waves, circularGoesOutFromItsCentre) {
    const Wave wave = waveOf(WaveType::Circular);
    const double angle = 2 * M_PI / 0.8 * (0.5 - 0.7 * 1.5) + glm::radians(25.0);
    EXPECT_NEAR(heightAndSlope(wave, {0.7f, -0.3f}, 1.5).x, 0.05 * std::cos(angle), 1e-6);
    EXPECT_EQ(heightAndSlope(wave, {0.2f, -0.3f}, 1.5).y, 0) << "no slope, and no NaN, at the centre";
}

TEST(Waves, slopesAreTheDerivativesOfTheHeight) {
    constexpr float step = 1e-3f;
    for (const WaveType type : {WaveType::Cosine, WaveType::Circular, WaveType::Noise}) {
        const Wave wave = waveOf(type);
        double largest = 0;
        for (int i = 0; i < 200; ++i) {
            const glm::vec2 xz(0.37f * float(i % 20) - 2, 0.53f * float(i / 20) - 3);
            const glm::dvec3 here = heightAndSlope(wave, xz);
            const double dx = heightAndSlope(wave, xz + glm::vec2(step, 0)).x -
                              heightAndSlope(wave, xz - glm::vec2(step, 0)).x;
            const double dz = heightAndSlope(wave, xz + glm::vec2(0, step)).x -
                              heightAndSlope(wave, xz - glm::vec2(0, step)).x;
            // Float heights of 0.05 over a step of 2e-3: rounding alone is 4e-6.
            EXPECT_NEAR(here.y, dx / (2 * step), 3e-4);
            EXPECT_NEAR(here.z, dz / (2 * step), 3e-4);
            largest = std::max(largest, std::hypot(here.y, here.z));
        }
        Water water;
        water.waves = {wave};
        EXPECT_LE(largest, steepestSlope(water)) << "the bound holds";
        EXPECT_GT(largest, 0.2 * steepestSlope(water)) << "and is not idle";
    }
}

TEST(Waves, doNotDependOnWhereTheOriginIs) {
    const glm::dvec3 far(1000000, 0, -2000000);
    for (const WaveType type : {WaveType::Cosine, WaveType::Circular, WaveType::Noise}) {
        Wave there = waveOf(type);
        const glm::dvec3 near = heightAndSlope(there, {0.3f, 0.4f}, 1);
        there.center += glm::dvec2(far.x, far.z);
        if (type == WaveType::Cosine)
            there.phase -= glm::degrees(2 * M_PI / 0.8 * std::fmod(0.6 * far.x + 0.8 * far.z, 0.8));
        const glm::dvec3 moved =
            heightAndSlope(there, {0.3f, 0.4f}, 1, type == WaveType::Noise ? glm::dvec3(0) : far);
        EXPECT_NEAR(near.x, moved.x, 1e-6);
        EXPECT_NEAR(near.y, moved.y, 1e-5);
    }
}

TEST(Waves, noiseAtAFarOriginIsNoiseThere) {
    const Wave wave = waveOf(WaveType::Noise);
    const glm::dvec3 shifted = heightAndSlope(wave, {0.3f, 0.4f}, 0, {100.5, 0, -20.25});
    const glm::dvec3 direct = heightAndSlope(wave, {100.8f, -19.85f}, 0);
    EXPECT_NEAR(shifted.x, direct.x, 2e-5);
}

TEST(Waves, staySharpAfterADay) {
    const Wave wave = waveOf(WaveType::Cosine);
    const double period = wave.wavelength / wave.speed;
    EXPECT_NEAR(heightAndSlope(wave, {0.1f, 0.2f}, 0.3).x,
                heightAndSlope(wave, {0.1f, 0.2f}, 0.3 + 75600 * period).x, 1e-6);
}

TEST(Waves, noiseSeedsDiffer) {
    Wave wave = waveOf(WaveType::Noise);
    const double first = heightAndSlope(wave, {0.33f, 0.21f}).x;
    wave.seed = 6;
    EXPECT_NE(first, heightAndSlope(wave, {0.33f, 0.21f}).x);
}

} // namespace
} // namespace limpid
