// Ground truth as a host asks for it.
#include "core/ErrorOf.h"
#include "reference/Truth.h"

#include <cmath>
#include <memory>

#include <gtest/gtest.h>

#include "core/Error.h"
#include "engine/Scenes.h"
#include "scene/HostMesh.h"

namespace limpid::reference {
namespace {

Scene calmFloor() {
    Scene scene;
    scene.receivers = {scenes::floorAt(-1)};
    scene.lights = {scenes::sunAt(0)};
    scene.water.center = glm::dvec2(0);
    scene.water.size = glm::dvec2(3);
    scene.caustics.mapSize = 16;
    return scene;
}

using test::errorOf;

TEST(Truth, underCalmWaterIsWhatFresnelLetsThrough) {
    const io::Bake bake = truthOf(calmFloor(), 0, {.photons = 20'000});
    ASSERT_EQ(bake.maps.size(), 1u);
    const double through = 1 - std::pow(0.333 / 2.333, 2);
    const io::BakedMap& map = bake.maps[0];
    for (int y = 2; y < map.size.y - 2; ++y) // light on the edge comes by single photons, which are noise
        for (int x = 2; x < map.size.x - 2; ++x)
            EXPECT_NEAR(double(map.irradiance[3 * std::size_t(map.size.x * y + x)]), through, 1e-6);
}

TEST(Truth, saysWhatItExpects) {
    EXPECT_EQ(errorOf([] { truthOf(calmFloor(), 0, {.photons = 0}); }),
              "photons: expected at least 1, got 0");
    EXPECT_EQ(errorOf([] { truthOf(calmFloor(), NAN, {}); }), "seconds: expected a finite number, got nan");
    Scene scene = calmFloor();
    scene.receivers[0].host = std::make_shared<const HostMesh>();
    EXPECT_EQ(errorOf([&] { truthOf(scene, 0, {}); }),
              "receiver \"floor\": expected triangles in memory, found a HostMesh");
    scene.receivers[0].mesh = nullptr;
    EXPECT_EQ(errorOf([&] { truthOf(scene, 0, {}); }), "receiver \"floor\": expected a mesh, got none");
}

} // namespace
} // namespace limpid::reference
