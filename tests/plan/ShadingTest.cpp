#include "plan/Shading.h"

#include <gtest/gtest.h>

#include "engine/Scenes.h"

namespace limpid {
namespace {

TEST(Shading, aBoxMeetsTheHullOfTwoOthers) {
    const Bounds low{{-1, -2, -1}, {1, -1, 1}}, high{{5, 0, -1}, {7, 0, 1}};
    const auto meets = [&](const glm::dvec3& at, double half) {
        return meetsHull({at - half, at + half}, low, high);
    };
    EXPECT_TRUE(meets({0, -1.5, 0}, 0.1)) << "within one";
    EXPECT_TRUE(meets({6, 0, 0}, 0.1)) << "within the other";
    EXPECT_TRUE(meets({3, -0.6, 0}, 0.1)) << "between them";
    EXPECT_FALSE(meets({0, -0.2, 0}, 0.1)) << "above the first, beside the way";
    EXPECT_FALSE(meets({6, -1.5, 0}, 0.1)) << "below the second";
    EXPECT_FALSE(meets({3, -0.6, 1.3}, 0.1)) << "aside";
    EXPECT_TRUE(meets({3, -0.6, 1.3}, 0.4));
    EXPECT_FALSE(meets({3, 1, 0}, 0.5)) << "over both";
}

std::vector<int> shaders(const Scene& scene, int receiver) {
    const Plan plan = planOf(scene);
    for (const PlannedMap& map : plan.maps)
        if (map.receiver == receiver) return mayShade(scene, plan, map);
    return {};
}

TEST(Shading, whatIsInTheLightsWayMayShade) {
    Scene scene;
    scene.lights = {scenes::sunAt(0)};
    const auto ball = [](double x, double y) {
        return scenes::shape("ball", makeSphere(0.1, glm::vec3(0.8f)), {x, y, 0});
    };
    scene.receivers = {scenes::floorAt(-1, 4), ball(0, -0.5), ball(0, -0.2), ball(1, -0.5)};
    EXPECT_EQ(shaders(scene, 0), (std::vector<int>{0, 1, 2, 3}));
    EXPECT_EQ(shaders(scene, 1), (std::vector<int>{1, 2})) << "the ball above it";
    EXPECT_EQ(shaders(scene, 2), (std::vector<int>{2}));
    EXPECT_EQ(shaders(scene, 3), (std::vector<int>{3}));
    // Light from -x: a ball at the other's left shades it.
    scene.lights = {scenes::sunAt(85)};
    scene.receivers = {ball(0, -1), ball(-0.6, -0.4), ball(0.6, -0.4)};
    EXPECT_EQ(shaders(scene, 0), (std::vector<int>{0, 1}));
    // Steep waves throw light from all sides.
    scene.water.waves = {scenes::cosine(0.2, 1, {1, 0})};
    EXPECT_EQ(shaders(scene, 0), (std::vector<int>{0, 1, 2}));
}

} // namespace
} // namespace limpid
