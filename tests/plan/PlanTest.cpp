#include "plan/Framing.h"
#include "plan/Plan.h"

#include <gtest/gtest.h>

#include "engine/Scenes.h"

namespace limpid {
namespace {

/// A floor and a ball half out of the water, under a sun and a point light that is below the level.
Scene pond() {
    Scene scene;
    scene.receivers = {scenes::floorAt(-1),
                       scenes::shape("ball", makeSphere(0.4, glm::vec3(0.8f)), {0, 0, 0})};
    scene.lights = {scenes::sunAt(30), scenes::pointLightAt({0.2, -0.5, 0})};
    scene.water.waves = {scenes::cosine(0.01, 0.5, {1, 0.3})};
    return scene;
}

TEST(Plan, tellsEachReceiversPartsOnBothSides) {
    const Plan plan = planOf(pond());
    ASSERT_EQ(plan.receivers.size(), 2u);
    EXPECT_NEAR(plan.receivers[0].wet.max.y, -1, 1e-12);
    EXPECT_NEAR(plan.receivers[1].wet.max.y, 0, 1e-12) << "where edges cross the level";
    EXPECT_NEAR(plan.receivers[1].wet.min.y, -0.4, 1e-6);
    EXPECT_NEAR(plan.receivers[1].bounds.max.y, 0.4, 1e-6);
    EXPECT_NEAR(plan.sides.dry.min.y, 0, 1e-12);
    EXPECT_NEAR(plan.sides.dry.max.y, 0.4, 1e-6);
    EXPECT_NEAR(plan.sides.wet.min.y, -1, 1e-12);
    EXPECT_FALSE(plan.dry.empty());
}

TEST(Plan, tellsWhichLightsEnterAndHowFarTheyGo) {
    const Plan plan = planOf(pond());
    ASSERT_EQ(plan.lights.size(), 2u);
    EXPECT_TRUE(plan.lights[0].enters);
    EXPECT_FALSE(plan.lights[1].enters) << "a lamp below the level";
    // Straight down it is 1 m; by Snell's law at 30°, 1 / cos 22.03°.
    EXPECT_NEAR(plan.lights[0].farthest, 1.02 * 1.0787, 1e-3);
    EXPECT_GT(plan.lights[0].frame.surfaceShadowRect.z, 0) << "the ball stands out of the water";
}

TEST(Plan, hasAMapForEachLightAndWetReceiver) {
    Scene scene = pond();
    scene.receivers.push_back(scenes::floorAt(2));
    const Plan plan = planOf(scene);
    ASSERT_EQ(plan.maps.size(), 4u) << "what is dry has none";
    for (const PlannedMap& map : plan.maps)
        EXPECT_LT(map.receiver, 2);
    EXPECT_EQ(plan.maps[0].light, 0);
    EXPECT_EQ(plan.maps[2].light, 1);
    EXPECT_TRUE(plan.maps[0].inReach);
    // Seen along light that goes down at 22.03°, depth grows by its tangent across a level floor.
    EXPECT_NEAR(glm::length(plan.maps[0].gradients.mean), 0.4046, 1e-3);
}

TEST(Framing, placesACameraThatTheSceneLeavesOpen) {
    Scene scene = pond();
    const Camera camera = framedCamera(scene);
    ASSERT_TRUE(camera.position && camera.target);
    EXPECT_GT(camera.position->y, scene.water.level);
    scene.camera.position = {1, 2, 3};
    EXPECT_EQ(*framedCamera(scene).position, glm::dvec3(1, 2, 3));
}

TEST(Plan, doesNotDependOnHowCausticsAreComputed) {
    Scene scene = pond();
    const Plan before = planOf(scene);
    scene.caustics.method = Method::PhotonSplat;
    scene.caustics.mapSize = 17;
    scene.caustics.planes = 3;
    const Plan after = planOf(scene);
    EXPECT_EQ(before.patch.size, after.patch.size);
    ASSERT_EQ(before.maps.size(), after.maps.size());
    for (std::size_t i = 0; i < before.maps.size(); ++i)
        EXPECT_EQ(before.maps[i].box.corner, after.maps[i].box.corner);
}

TEST(Plan, takesFromOneBeforeWhatMeshesDecide) {
    Scene scene = pond();
    const Plan before = planOf(scene);
    for (Receiver& receiver : scene.receivers)
        receiver.translation.x += 0.1;
    scene.receivers[0].scale.x = -1; // mirrored: no solid, though the mesh is what it was
    const Plan anew = planOf(scene), after = planOf(scene, before.receivers);
    EXPECT_EQ(anew.maps, after.maps);
    ASSERT_EQ(anew.receivers.size(), after.receivers.size());
    for (std::size_t i = 0; i < anew.receivers.size(); ++i) {
        EXPECT_EQ(anew.receivers[i].closed, after.receivers[i].closed);
        EXPECT_EQ(anew.receivers[i].solid, after.receivers[i].solid);
    }
    EXPECT_FALSE(after.receivers[0].solid);
}

TEST(Plan, countsFarScenesFromTheirMiddle) {
    Scene scene = pond();
    for (Receiver& receiver : scene.receivers)
        receiver.translation += glm::dvec3(1e6, 0, 0);
    const Plan plan = planOf(scene);
    EXPECT_NEAR(plan.origin.x, 1e6, 1);
    EXPECT_LT(std::abs(plan.receivers[0].bounds.center().x), 1) << "near that origin";
    EXPECT_NEAR(plan.receivers[0].wet.center().x, 1e6, 1) << "in the world";
}

} // namespace
} // namespace limpid
