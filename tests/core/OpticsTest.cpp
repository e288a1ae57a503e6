#include <cmath>

#include <gtest/gtest.h>

#include "core/Optics.h"

namespace limpid {
namespace {

constexpr double ior = 1.333;

glm::dvec3 incidentAt(double degrees) {
    return {std::sin(glm::radians(degrees)), -std::cos(glm::radians(degrees)), 0};
}

TEST(Refraction, followsSnell) {
    for (const double degrees : {0.0, 10.0, 30.0, 60.0, 80.0, 89.0}) {
        const glm::dvec3 t = optics::refractDirection(incidentAt(degrees), {0, 1, 0}, 1 / ior);
        EXPECT_NEAR(ior * t.x, std::sin(glm::radians(degrees)), 1e-14) << degrees;
        EXPECT_NEAR(glm::length(t), 1, 1e-14);
        EXPECT_LT(t.y, 0);
    }
}

TEST(Refraction, isTotalBeyondTheCriticalAngleFromWater) {
    const double critical = glm::degrees(std::asin(1 / ior));
    EXPECT_GT(glm::length(optics::refractDirection(incidentAt(critical - 0.1), {0, 1, 0}, ior)), 0.99);
    EXPECT_EQ(optics::refractDirection(incidentAt(critical + 0.1), {0, 1, 0}, ior), glm::dvec3(0));
    EXPECT_EQ(optics::fresnelTransmittance(std::cos(glm::radians(critical + 0.1)), ior), 0);
}

TEST(Fresnel, matchesClosedForms) {
    // Normal incidence: 1 - ((n - 1) / (n + 1))².
    EXPECT_NEAR(optics::fresnelTransmittance(1.0, 1 / ior), 1 - std::pow((ior - 1) / (ior + 1), 2), 1e-14);
    // Brewster's angle: the parallel part is not reflected, and reflected and refracted ray are at right
    // angles.
    const double brewster = std::atan(ior);
    const double perpendicular = std::pow(std::cos(2 * brewster), 2);
    EXPECT_NEAR(optics::fresnelTransmittance(std::cos(brewster), 1 / ior), 1 - 0.5 * perpendicular, 1e-14);
    EXPECT_EQ(optics::fresnelTransmittance(0.0, 1 / ior), 0);
    EXPECT_EQ(optics::fresnelTransmittance(-0.5, 1 / ior), 0);
    EXPECT_NEAR(optics::fresnelTransmittance(0.3, 1.0), 1, 1e-14) << "no step of the index, no reflection";
}

TEST(Fresnel, isTheSameBothWays) {
    for (const double degrees : {5.0, 40.0, 75.0}) {
        const double refracted = std::asin(std::sin(glm::radians(degrees)) / ior);
        EXPECT_NEAR(optics::fresnelTransmittance(std::cos(glm::radians(degrees)), 1 / ior),
                    optics::fresnelTransmittance(std::cos(refracted), ior), 1e-13);
    }
}

TEST(FlatCrossing, bendsByItsLaw) {
    for (const double above : {1e-3, 0.5, 20.0})
        for (const double below : {1e-3, 1.0, 30.0})
            for (const double across : {0.0, 0.1, 3.0, 200.0}) {
                const double x = optics::flatCrossing(above, below, across, ior);
                const double up = x / std::hypot(x, above),
                             down = (across - x) / std::hypot(across - x, below);
                EXPECT_NEAR(up, ior * down, 1e-9) << above << ' ' << below << ' ' << across;
                EXPECT_GE(x, 0);
                EXPECT_LE(x, across);
            }
}

TEST(FlatCrossing, holdsInSinglePrecision) {
    for (const float across : {0.01f, 0.7f, 5.0f})
        EXPECT_NEAR(shader::flatCrossing(1.5f, 0.8f, across, 1.333f),
                    optics::flatCrossing(1.5, 0.8, across, 1.333), 2e-6 * double(across));
}

TEST(Planes, eachDepthBelongsToExactlyOne) {
    const double height = 0.37;
    for (const int count : {1, 2, 3, 50, 101}) {
        EXPECT_EQ(optics::planeIndex(0.0, height, count), 0);
        EXPECT_EQ(optics::planeIndex(height, height, count), count - 1);
        for (int i = 0; i <= 1000; ++i) {
            const double depth = height * i / 1000;
            const int index = optics::planeIndex(depth, height, count);
            const double slack = count > 1 ? 0.5 * optics::planeGap(height, count) + 1e-12 : height;
            EXPECT_LE(std::abs(optics::planeDepth(height, count, index) - depth), slack);
        }
    }
    EXPECT_EQ(optics::planeDepth(height, 1, 0), 0.5 * height) << "one plane lies in the middle";
    EXPECT_EQ(optics::planeDepth(height, 7, 6), height) << "both faces are planes";
}

TEST(Octahedral, keepsDirectionsInSixteenBits) {
    for (int i = 0; i < 2000; ++i) {
        const float z = 1 - 2 * (float(i) + 0.5f) / 2000, angle = 2.399963f * float(i);
        const float r = std::sqrt(1 - z * z);
        const glm::vec3 n(r * std::cos(angle), r * std::sin(angle), z);
        const glm::vec2 stored = glm::round(shader::octahedralEncode(n) * 65535.0f) / 65535.0f;
        EXPECT_LT(glm::distance(shader::octahedralDecode(stored), n), 6e-5f);
    }
}

TEST(Extinction, actsOnEachColour) {
    const glm::dvec3 left = optics::extinction({0.5, 0.1, 0}, 2.0);
    EXPECT_NEAR(left.x, std::exp(-1.0), 1e-15);
    EXPECT_NEAR(left.y, std::exp(-0.2), 1e-15);
    EXPECT_EQ(left.z, 1);
    EXPECT_EQ(optics::extinction({0.5, 0.1, 0}, -3.0), glm::dvec3(1)) << "never adds light";
}

TEST(Phase, ofAllTurnsIsOneAndTurnsByG) {
    constexpr int steps = 100000;
    for (const float g : {-0.5f, 0.0f, 0.6f, 0.9f}) {
        double whole = 0, mean = 0, simple = 0;
        for (int i = 0; i < steps; ++i) {
            const float turn = 2 * (float(i) + 0.5f) / steps - 1;
            const double share = 4 * M_PI / steps;
            whole += share * double(shader::henyeyGreenstein(turn, g));
            mean += share * double(turn * shader::henyeyGreenstein(turn, g));
            simple += share * double(shader::schlickPhase(turn, g));
        }
        // Single precision in every one of the terms.
        EXPECT_NEAR(whole, 1, 1e-4) << g;
        EXPECT_NEAR(mean, double(g), 1e-4) << g;
        EXPECT_NEAR(simple, 1, 1e-4) << g;
    }
}

} // namespace
} // namespace limpid
