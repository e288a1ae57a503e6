#include "scene/Spectrum.h"

#include <cmath>

#include <gtest/gtest.h>

#include "scene/SlowWaves.h"

namespace limpid {
namespace {

double meanSquare(const Spectrum& spectrum, double time) {
    double sum = 0;
    for (int row = 0; row < spectrum.modes; ++row)
        for (int column = 0; column < spectrum.modes; ++column)
            sum += std::norm(spectrum.at(column, row, time));
    return sum;
}

TEST(Spectrum, hasItsEnergyAtAllTimes) {
    for (const int modes : {4, 16, 64}) {
        const auto spectrum = phillipsSpectrum({.velocity = {3, 1}, .tile = {4, 3}, .modes = modes});
        for (const double time : {0.0, 0.7, 1e5})
            EXPECT_NEAR(meanSquare(*spectrum, time), 1, 1e-12) << modes << " modes at " << time << " s";
    }
}

TEST(Spectrum, obeysParseval) {
    // Samples at as many places as there are modes hold all of the energy.
    const auto spectrum = phillipsSpectrum({.velocity = {2, -1}, .tile = {4, 3}, .modes = 16, .seed = 5});
    double heights = 0, slopes = 0;
    for (int z = 0; z < 16; ++z)
        for (int x = 0; x < 16; ++x) {
            const glm::dvec3 at =
                test::slowWaves(*spectrum, spectrum->tile * (glm::dvec2(x, z) + 0.3) / 16.0, 2);
            heights += at.x * at.x / 256;
            slopes += (at.y * at.y + at.z * at.z) / 256;
        }
    EXPECT_NEAR(heights, 1, 1e-12);
    EXPECT_NEAR(std::sqrt(slopes), spectrum->rmsSlope, 1e-12);
}

TEST(Spectrum, runsWithTheWindAsFastAsItsWavesAre) {
    // One mode alone: y = 2 |h0| cos(k·x - ωt + phase).
    Spectrum one = *phillipsSpectrum({.velocity = {3, 0}, .tile = {2, 2}, .modes = 8, .seed = 1});
    const std::size_t kept = 4 * 8 + 6; // column 6, row 4: two waves along x
    for (std::size_t i = 0; i < one.amplitudes.size(); ++i)
        if (i != kept) one.amplitudes[i] = 0;
    ASSERT_GT(std::abs(one.amplitudes[kept]), 0);
    // Waves of 1 m are waves of gravity: 1.2496 m/s (Lamb § 267); surface tension adds 0.02 %.
    constexpr double speed = 1.2496;
    const glm::dvec2 place(0.3, 0.1);
    for (const double time : {0.1, 3.0})
        EXPECT_NEAR(test::slowWaves(one, place, 0).x,
                    test::slowWaves(one, place + glm::dvec2(speed * time, 0), time).x,
                    3e-4 * 6.3 * speed * time * 2 * std::abs(one.amplitudes[kept]));
    // Of 1.72 cm, where both count alike, 23.1 cm/s: the slowest that water has (Lamb § 267).
    constexpr double k = 2 * 3.14159265358979 / 0.0172;
    EXPECT_NEAR(Spectrum::frequency(k) / k, 0.231, 5e-4);
}

TEST(Spectrum, keepsItsLongWavesWithMoreModes) {
    const Wind coarse{.velocity = {3, 2}, .tile = {4, 4}, .modes = 16, .shortest = 0.5, .seed = 9};
    Wind fine = coarse;
    fine.modes = 32;
    const auto a = phillipsSpectrum(coarse), b = phillipsSpectrum(fine);
    const std::complex<double> ratio = b->amplitudes[16 * 32 + 18] / a->amplitudes[8 * 16 + 10];
    EXPECT_NEAR(ratio.imag(), 0, 1e-12);
    for (int row = 1; row < 16; ++row)
        for (int column = 1; column < 16; ++column)
            EXPECT_NEAR(std::abs(b->amplitudes[std::size_t((row + 8) * 32 + column + 8)] -
                                 ratio * a->amplitudes[std::size_t(row * 16 + column)]),
                        0, 1e-12);
    fine.seed = 10;
    EXPECT_NE(phillipsSpectrum(fine)->amplitudes, b->amplitudes);
}

TEST(Spectrum, hasNoWavesAgainstTheWindAndFewAcross) {
    double along = 0, across = 0;
    for (std::uint32_t seed = 0; seed < 100; ++seed) {
        const auto spectrum =
            phillipsSpectrum({.velocity = {-2, 0}, .tile = {4, 4}, .modes = 16, .seed = seed});
        for (int row = 1; row < 16; ++row)
            for (int column = 1; column < 16; ++column) {
                const glm::dvec2 k = spectrum->wavenumber(column, row);
                const double energy = std::norm(spectrum->amplitudes[std::size_t(row * 16 + column)]);
                if (k.x >= 0) {
                    EXPECT_EQ(energy, 0);
                }
                if (std::abs(k.x) != std::abs(k.y))
                    (std::abs(k.x) > std::abs(k.y) ? along : across) += energy;
            }
    }
    // Of cos² over the half circle, the quarter around the wind has (π + 2) / (2π) = 0.82. One mode carries
    // most of a draw, so a hundred draws are about a hundred throws of a coin: four deviations of 0.04 are
    // left.
    EXPECT_NEAR(along / (along + across), 0.82, 0.16);
}

TEST(Spectrum, isNoneWithoutWind) {
    EXPECT_EQ(phillipsSpectrum({.velocity = {0.01, 0}}), nullptr);
}

TEST(Spectrum, staysWithinItsBounds) {
    const auto spectrum = phillipsSpectrum({.velocity = {3, 1}, .tile = {2, 2}, .modes = 16, .seed = 3});
    double highest = 0, steepest = 0;
    for (int i = 0; i < 5000; ++i) {
        const glm::dvec3 at = test::slowWaves(*spectrum, {0.618 * i, 0.0137 * i}, 0.01 * i);
        highest = std::max(highest, std::abs(at.x));
        steepest = std::max(steepest, std::hypot(at.y, at.z));
    }
    EXPECT_LT(highest, spectrum->highest);
    EXPECT_GT(highest, 0.4 * spectrum->highest);
    EXPECT_LT(steepest, spectrum->steepest);
    EXPECT_GT(steepest, 0.4 * spectrum->steepest);
}

} // namespace
} // namespace limpid
