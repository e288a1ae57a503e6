// What one receiver takes, none behind it gets, in each beam's own direction.
#include <algorithm>

#include "engine/EngineFixture.h"

namespace limpid {
namespace {

class OcclusionGLTest : public EngineGLTest {
  protected:
    static constexpr double leastFacing = 0.25;

    static Scene rough(double degrees) {
        Scene scene;
        scene.lights = {scenes::sunAt(degrees)};
        scene.water.grid = {128, 128};
        scene.water.size = {3, 3};
        scene.water.waves = {scenes::cosine(0.015, 0.3, {1, 0.4})};
        scene.caustics.mapSize = 256;
        scene.caustics.method = Method::ExactBeam;
        return scene;
    }
    static Receiver slab(const char* name, const glm::dvec3& size, const glm::dvec3& at) {
        return scenes::shape(name, makeBox(size, glm::vec3(0.8f)), at);
    }
    /// The greatest irradiance where `inside` says yes to a texel's place, W/m².
    template <typename Inside>
    static double greatest(const MapData& map, const Inside& inside) {
        double most = 0;
        int places = 0;
        for (std::size_t i = 0; i < map.irradiance.size() / 3; ++i) {
            const float* p = &map.position[4 * i];
            // Steeper texels reach far down.
            if (p[3] == 0 || map.normalDotAxis[i] < leastFacing || !inside(glm::dvec3(p[0], p[1], p[2])))
                continue;
            ++places;
            most = std::max<double>(most, map.irradiance[3 * i]);
        }
        EXPECT_GT(places, 100);
        return most;
    }
};

TEST_F(OcclusionGLTest, lightThatPassesAGapEndsAtWhatLiesBehindIt) {
    // Two slabs with a gap between them, a third below the gap. Waves of slope 0.31 turn light by 0.08 and
    // less: none gets around the third (0.2 m aside in 0.6 m) to the middle of the floor.
    Scene scene = rough(0);
    scene.receivers = {scenes::floorAt(-1.5), slab("left", {0.7, 0.05, 1.4}, {-0.37, -0.5, 0}),
                       slab("right", {0.7, 0.05, 1.4}, {0.37, -0.5, 0}),
                       slab("below", {0.6, 0.05, 0.6}, {0, -0.9, 0})};
    const Baked baked = bake(scene);
    EXPECT_EQ(greatest(baked.maps.at(0),
                       [](const glm::dvec3& p) { return std::max(std::abs(p.x), std::abs(p.z)) < 0.1; }),
              0);
    EXPECT_GT(greatest(baked.maps.at(3), [](const glm::dvec3&) { return true; }), 0.5)
        << "the gap lets light in";
}

TEST_F(OcclusionGLTest, whatIsInsideAnotherReceiverIsDark) {
    // A ball's lit flank goes on down into a slab. Along the light, a texel that faces it by 0.25 spans 3.9
    // times its width (2.3 mm), as does what a texel of the scene depth map (3.7 mm) is off sideways; half of
    // one more is what surfaces that touch may differ by: 25 mm.
    Scene scene = rough(40);
    scene.receivers = {scenes::shape("ball", makeSphere(0.3, glm::vec3(0.8f)), {0, -0.9, 0}),
                       slab("slab", {1.4, 0.5, 1.4}, {0, -1.15, 0})};
    const Baked baked = bake(scene);
    EXPECT_GT(greatest(baked.maps.at(0), [](const glm::dvec3& p) { return p.y > -0.9; }), 0.5);
    EXPECT_EQ(greatest(baked.maps.at(0), [](const glm::dvec3& p) { return p.y < -0.9 - 0.025; }), 0);
}

} // namespace
} // namespace limpid
