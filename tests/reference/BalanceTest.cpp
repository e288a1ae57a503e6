// Where light goes in the reference, and that it is the same every time.
#include <cstring>
#include <numbers>

#include <gtest/gtest.h>

#include "reference/Traced.h"

namespace limpid {
namespace {

/// A sphere and a fish over a floor, waves, water that takes light, sun and point light.
Scene rich() {
    Scene scene;
    scene.receivers = {scenes::floorAt(-1.5, 3),
                       scenes::shape("sphere", makeSphere(0.3, glm::vec3(0.8f)), {0.5, -0.8, 0}),
                       scenes::model("fish", -1)};
    scene.water.waves = {scenes::cosine(0.01, 0.5, {1, 0.3}), scenes::noise(0.01, 0.6)};
    scene.water.absorption = {0.3, 0.1, 0.05};
    scene.water.scattering = {0.02, 0.03, 0.04};
    Light pointLight;
    pointLight.name = "lamp";
    pointLight.type = LightType::Point;
    pointLight.position = {0.4, 0.3, 0.2};
    scene.lights = {scenes::sunAt(30), pointLight};
    scene.caustics.mapSize = 128;
    return scene;
}

TEST(Balance, nothingIsLostOrMade) {
    const test::Traced traced = test::trace(rich(), 100'000);
    for (const reference::TracedLight& light : traced.result.lights) {
        printf("entering %.6f, residual %.2e, rejected %.4f\n", light.entering, light.residual(),
               light.rejected);
        EXPECT_LT(std::abs(light.residual()), 1e-6 * light.entering)
            << "floats in the maps; the bar is 0.1 %";
        EXPECT_LT(light.rejected, 0.02 * light.entering);
        EXPECT_GT(light.absorbed, 0.05 * light.entering);
        EXPECT_GT(light.scattered, 0.01 * light.entering);
        EXPECT_GT(light.missed, 0);
    }
}

TEST(Balance, aSpotSendsWhatItsConeHolds) {
    Scene scene;
    scene.receivers = {scenes::floorAt(-1)};
    scene.caustics.mapSize = 32;
    Light spot;
    spot.type = LightType::Point;
    spot.position = {0.1, 1, 0.05};
    spot.innerCone = 6;
    spot.outerCone = 14;
    scene.lights = {spot};
    scene.water.size = glm::dvec2(2);
    scene.water.center = glm::dvec2(0);
    const test::Traced traced = test::trace(scene, 100'000);
    // The cone looks straight down: a ring at polar angle p has 2 pi sin p of solid angle
    // (KHR_lights_punctual).
    const double inner = std::cos(glm::radians(6.0)), outer = std::cos(glm::radians(14.0));
    double expected = 0;
    constexpr int rings = 4000;
    for (int i = 0; i < rings; ++i) {
        const double angle = (i + 0.5) / rings * glm::radians(14.0);
        const double share = std::clamp((std::cos(angle) - outer) / (inner - outer), 0.0, 1.0);
        expected += share * share * 2 * std::numbers::pi * std::sin(angle) * glm::radians(14.0) / rings *
                    test::transmittance(angle, scene.water.ior);
    }
    EXPECT_NEAR(traced.light().entering, expected, 1e-3 * expected);
    EXPECT_EQ(traced.irradiance(0, 0, 0), 0) << "past the cone";
}

TEST(Balance, aPointLightSendsItsSolidAngleThroughTheSurface) {
    for (const double height : {0.001, 0.05, 2.0}) {
        Scene scene;
        scene.receivers = {scenes::floorAt(-1)};
        scene.caustics.mapSize = 32;
        Light pointLight;
        pointLight.type = LightType::Point;
        pointLight.position = {0.2, height, 0.1};
        scene.lights = {pointLight};
        scene.water.size = glm::dvec2(3);
        scene.water.center = glm::dvec2(0);
        const test::Traced traced = test::trace(scene, 100'000);
        // The whole solid angle of the rectangle, ring by ring of equal steps in the polar angle.
        double expected = 0;
        constexpr int rings = 2000, turns = 360;
        for (int i = 0; i < rings; ++i) {
            const double polar = (i + 0.5) / rings * std::numbers::pi / 2;
            int inside = 0;
            for (int k = 0; k < turns; ++k) {
                const double turn = 2 * std::numbers::pi * (k + 0.5) / turns, r = height * std::tan(polar);
                inside +=
                    std::abs(0.2 + r * std::cos(turn)) < 1.5 && std::abs(0.1 + r * std::sin(turn)) < 1.5;
            }
            expected += 2 * std::numbers::pi * inside / turns * std::sin(polar) *
                        (std::numbers::pi / 2 / rings) * test::transmittance(polar, 1.333);
        }
        EXPECT_NEAR(traced.light().entering, expected, 0.001 * expected) << height;
    }
}

TEST(Balance, aPointLightAtTheWaterIsFollowedAsFinelyAsOneFarAway) {
    for (const double height : {0.005, 2.0}) {
        Scene scene;
        scene.receivers = {scenes::floorAt(-1),
                           scenes::shape("ball", makeSphere(0.2, glm::vec3(0.8f)), {0, -0.5, 0})};
        scene.water.waves = {scenes::cosine(0.001, 0.3, {1, 0})};
        scene.caustics.mapSize = 64;
        Light pointLight;
        pointLight.type = LightType::Point;
        pointLight.position = {0.3, height, 0.1};
        scene.lights = {pointLight};
        const test::Traced traced = test::trace(scene, 200'000);
        // When cells close to the point light, which are small but light much, went by their size: 8 and 14
        // %.
        EXPECT_LT(traced.map(0).standardError, 0.03) << height;
        EXPECT_LT(traced.map(1).standardError, 0.03) << height;
    }
}

TEST(Balance, lightsInTheWaterMakeNoCaustics) {
    Scene scene = rich();
    scene.lights[1].position.y = -0.2;
    scene.lights[0].direction = {1, 0.1, 0};
    const test::Traced traced = test::trace(scene, 10000);
    ASSERT_GE(traced.result.maps.size(), 6u);
    for (const auto& map : traced.result.maps) {
        EXPECT_EQ(map.deposited, 0);
        EXPECT_EQ(map.standardError, 0);
        EXPECT_TRUE(std::any_of(map.position.begin(), map.position.end(), [](float p) { return p == 1; }));
    }
    EXPECT_EQ(traced.light(0).entering, 0);
    EXPECT_EQ(traced.light(1).entering, 0);
}

bool sameBits(const test::Traced& a, const test::Traced& b) {
    for (std::size_t i = 0; i < a.result.maps.size(); ++i)
        if (std::memcmp(a.map(i).irradiance.data(), b.map(i).irradiance.data(),
                        a.map(i).irradiance.size() * sizeof(float)) != 0)
            return false;
    return a.light(0).rejected == b.light(0).rejected && a.light(1).absorbed == b.light(1).absorbed;
}

TEST(Repeat, theSameBitsWhateverTheNumberOfThreads) {
    Scene scene = rich();
    scene.caustics.mapSize = 48;
    const test::Traced one = test::trace(scene, 10'000, 5, 1);
    EXPECT_TRUE(sameBits(one, test::trace(scene, 10'000, 5, 2)));
    EXPECT_TRUE(sameBits(one, test::trace(scene, 10'000, 5, 5)));
    EXPECT_FALSE(sameBits(one, test::trace(scene, 10'000, 6, 2))) << "another seed";
}

TEST(Repeat, theStandardErrorSaysHowFarAnotherSeedIsOff) {
    Scene scene = rich();
    scene.receivers.pop_back();
    scene.lights.pop_back();
    const test::Traced a = test::trace(scene, 400'000, 1), b = test::trace(scene, 400'000, 2);
    for (std::size_t i = 0; i < a.result.maps.size(); ++i) {
        double error = 0, sum = 0;
        for (std::size_t k = 0; k < a.map(i).irradiance.size(); ++k) {
            error += std::abs(double(a.map(i).irradiance[k]) - double(b.map(i).irradiance[k]));
            sum += double(a.map(i).irradiance[k]);
        }
        // The difference of two independent maps is wider by √2. Eight batches tell a texel's deviation to a
        // quarter, thousands of texels the mean of them; rare events on few texels make the rest.
        const double expected = std::sqrt(2) * a.map(i).standardError;
        printf("difference %.3f %%, by the standard error %.3f %%\n", 100 * error / sum, 100 * expected);
        EXPECT_NEAR(error / sum, expected, 0.2 * expected);
    }
}

TEST(Repeat, farFromTheOriginNothingChanges) {
    Scene near;
    near.receivers = {scenes::floorAt(-1), scenes::model("sphere", -0.9)};
    near.receivers[1].scale = glm::dvec3(0.3);
    near.lights = {scenes::sunAt(30)};
    near.water.waves = {scenes::cosine(0.004, 0.25, {1, 0})};
    near.caustics.mapSize = 64;
    Scene far = near;
    for (Receiver& receiver : far.receivers)
        receiver.translation += glm::dvec3(1 << 20, 0, 0);
    const test::Traced a = test::trace(near, 100'000), b = test::trace(far, 100'000);
    for (std::size_t i = 0; i < 2; ++i) {
        double error = 0, sum = 0;
        for (std::size_t k = 0; k < a.map(i).irradiance.size(); ++k) {
            error += std::abs(double(a.map(i).irradiance[k]) - double(b.map(i).irradiance[k]));
            sum += double(a.map(i).irradiance[k]);
        }
        // Places of a double are 1e-10 m there; a few rays in 100,000 fall on the other side of an edge.
        EXPECT_LT(error / sum, 1e-3);
    }
}

} // namespace
} // namespace limpid
