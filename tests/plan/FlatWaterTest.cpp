#include "plan/FlatWater.h"

#include <cmath>

#include <gtest/gtest.h>

#include "engine/Scenes.h"
#include "plan/WaveTerms.h"

namespace limpid {
namespace {

TEST(EntryPoint, liesOnTheRefractedRay) {
    Water water;
    water.level = 0.5;
    const glm::dvec3 point(0.3, -1.2, -0.7);
    for (const Light& light :
         {scenes::sunAt(50), scenes::pointLightAt({-1, 2, 0.4}), scenes::pointLightAt({0.3, 0.501, -0.7})}) {
        const glm::dvec3 entry = entryPoint(light, water, point);
        EXPECT_EQ(entry.y, water.level);
        const glm::dvec3 way = glm::normalize(point - entry);
        EXPECT_LT(glm::distance(way, refractedAt(light, water, entry)), 1e-6);
        EXPECT_LT(glm::distance(way, meanDirection(light, water, point)), 1e-6);
    }
}

TEST(EntryPoint, meetsTheReceiversCentreUnlikeTheThesis) {
    // The thesis aims the ray at the centre before refraction; it then misses by what the water bends it.
    Water water;
    const Light light = scenes::pointLightAt({-2, 1, 0});
    const glm::dvec3 center(1, -1, 0);
    const glm::dvec3 straight(0, 0, 0);
    const glm::dvec3 t = refractedAt(light, water, straight);
    EXPECT_GT(std::abs(straight.x + t.x / -t.y - center.x), 0.05);
    const glm::dvec3 entry = entryPoint(light, water, center);
    const glm::dvec3 right = refractedAt(light, water, entry);
    EXPECT_NEAR(entry.x + right.x / -right.y, center.x, 1e-6);
}

TEST(EntersWater, knowsTheHorizonAndTheSurface) {
    Water water;
    EXPECT_TRUE(entersWater(scenes::sunAt(89.9), water));
    EXPECT_FALSE(entersWater(scenes::sunAt(90), water));
    EXPECT_FALSE(entersWater(scenes::sunAt(120), water));
    EXPECT_TRUE(entersWater(scenes::pointLightAt({0, 0.001, 0}), water));
    EXPECT_FALSE(entersWater(scenes::pointLightAt({0, -0.001, 0}), water));
}

TEST(CoveringPatch, holdsEveryStartOfARayToTheReceivers) {
    Scene scene;
    scene.receivers = {scenes::floorAt(-1)};
    scene.lights = {scenes::sunAt(45), scenes::sunAt(-70)};
    scene.water.waves = {scenes::cosine(0.01, 0.3, {1, 0.5})};
    const WaterPatch patch = coveringPatch(scene);
    const double steepest = steepestSlope(scene.water);
    for (const Light& light : scene.lights)
        for (int i = 0; i < 400; ++i) {
            const double angle = 0.1 * i, slope = steepest * (i % 7) / 6.0;
            const glm::dvec3 normal =
                glm::normalize(glm::dvec3(slope * std::cos(angle), 1, slope * std::sin(angle)));
            const glm::dvec3 t = refractedAt(light, scene.water, {}, normal);
            const glm::dvec3 point(i & 1 ? 1 : -1, -1, i & 2 ? 1 : -1);
            const glm::dvec3 start = point - t * (1 / -t.y);
            EXPECT_LE(std::abs(start.x - patch.center.x), 0.5 * patch.size.x);
            EXPECT_LE(std::abs(start.z - patch.center.y), 0.5 * patch.size.y);
        }
}

TEST(CoveringPatch, holdsWhatComesFromTheSunsRim) {
    Scene scene;
    scene.receivers = {scenes::floorAt(-1)};
    scene.lights = {scenes::sunAt(50)};
    const double small = coveringPatch(scene).size.x;
    scene.lights[0].angularDiameter = 10;
    const WaterPatch patch = coveringPatch(scene);
    EXPECT_GT(patch.size.x, small);
    for (const double degrees : {45.0, 55.0}) {
        const glm::dvec3 t = refractedAt(scenes::sunAt(degrees), scene.water, {});
        for (const double side : {-1.0, 1.0})
            EXPECT_LE(std::abs(side - t.x / -t.y - patch.center.x), 0.5 * patch.size.x);
    }
}

TEST(CoveringPatch, reachesAPointLightBesideALongReceiver) {
    // The nearest place of a long floor is lit from further out than any of its corners.
    Scene scene;
    scene.receivers = {scenes::shape("floor", makePlane({1, 10}, glm::vec3(1)), {0, -1, 0})};
    scene.lights = {scenes::pointLightAt({-3, 0.05, 0})};
    const WaterPatch patch = coveringPatch(scene);
    for (double z = -5; z <= 5; z += 0.25) {
        const glm::dvec3 entry = entryPoint(scene.lights[0], scene.water, {-0.5, -1, z});
        EXPECT_GE(entry.x, patch.min().x) << z;
    }
}

TEST(CoveringPatch, coversTheReceiversAroundAGivenCentre) {
    Scene scene;
    scene.receivers = {scenes::floorAt(-1)};
    scene.lights = {scenes::sunAt(0)};
    scene.water.center = {1, 0};
    const WaterPatch patch = coveringPatch(scene);
    EXPECT_LE(patch.min().x, -1);
    EXPECT_GE(patch.min().x + patch.size.x, 1);
}

TEST(CoveringPatch, takesWhatTheSceneAsksFor) {
    Scene scene;
    scene.receivers = {scenes::floorAt(-1)};
    scene.water.center = {3, 4};
    scene.water.size = {5, 6};
    const WaterPatch patch = coveringPatch(scene);
    EXPECT_EQ(patch.center, glm::dvec2(3, 4));
    EXPECT_EQ(patch.size, glm::dvec2(5, 6));
    EXPECT_EQ(patch.min(), glm::dvec2(0.5, 1));
}

} // namespace
} // namespace limpid
