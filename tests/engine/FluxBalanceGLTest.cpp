#include <cmath>

#include "engine/EngineFixture.h"

namespace limpid {
namespace {

class FluxBalanceGLTest : public EngineGLTest {
  protected:
    static Scene floorPastSphere() {
        Scene scene = scenes::floorPastSphere(45);
        scene.caustics.mapSize = 384;
        return scene;
    }
    static double share(const FluxBalance& flux) { return std::abs(flux.residual()) / flux.entering; }
};

TEST_F(FluxBalanceGLTest, floorPastASphereUnderFlatWater) {
    const Baked baked = bake(floorPastSphere(), true);
    const FluxBalance& flux = baked.flux.at(0);
    EXPECT_LT(share(flux), 0.01) << flux.residual() << " W of " << flux.entering;
    EXPECT_LT(std::abs(flux.rejected) / flux.entering, 0.01);
    EXPECT_GT(flux.missed, 0);

    // Nothing is lit twice: what the sphere takes is missing from the floor, and is the light on its disc.
    Scene alone = floorPastSphere();
    alone.receivers.pop_back();
    const double open = bake(alone).maps[0].deposited;
    const double disc = M_PI * 0.4 * 0.4 * baked.maps[0].deposited / open;
    EXPECT_NEAR(baked.maps[0].deposited + baked.maps[1].deposited, open, 0.005 * open);
    EXPECT_GT(baked.maps[1].deposited, 0.5 * disc);
}

TEST_F(FluxBalanceGLTest, absorbedAndScatteredAreCounted) {
    Scene scene = floorPastSphere();
    scene.water.absorption = {0.4, 0.2, 0.1};
    scene.water.scattering = {0.1, 0.1, 0.1};
    const FluxBalance flux = bake(scene, true).flux.at(0);
    EXPECT_LT(share(flux), 0.01);
    EXPECT_GT(flux.absorbed, 1.5 * flux.scattered);
    EXPECT_GT(flux.scattered, 0.05 * flux.entering);
}

TEST_F(FluxBalanceGLTest, underWaves) {
    Scene scene = floorPastSphere();
    scene.water.waves = {scenes::cosine(0.01, 0.3, {1, 0.4}), scenes::noise(0.01, 0.5)};
    const FluxBalance flux = bake(scene, true).flux.at(0);
    printf("residual under waves: %.3f %% of entering\n", 100 * flux.residual() / flux.entering);
    EXPECT_LT(share(flux), 0.002);
    EXPECT_LT(std::abs(flux.rejected), 0.002 * flux.entering);
}

TEST_F(FluxBalanceGLTest, aLampNearTheWater) {
    Scene scene = floorPastSphere();
    Light lamp;
    lamp.type = LightType::Point;
    lamp.position = {0.5, 0.6, 0.2};
    scene.lights = {lamp};
    const FluxBalance flux = bake(scene, true).flux.at(0);
    EXPECT_LT(share(flux), 0.02) << flux.residual() << " W of " << flux.entering;
}

TEST_F(FluxBalanceGLTest, aSpotPastTheSphere) {
    Scene scene = floorPastSphere();
    Light spot;
    spot.type = LightType::Point;
    spot.position = {0.3, 1.5, 0.2};
    spot.direction = {-0.1, -1, -0.1};
    spot.innerCone = 8;
    spot.outerCone = 20;
    scene.lights = {spot};
    const Baked baked = bake(scene, true);
    const FluxBalance& flux = baked.flux.at(0);
    EXPECT_LT(share(flux), 0.02) << flux.residual() << " W of " << flux.entering;
    // All of the cone lands on floor and sphere.
    EXPECT_NEAR(flux.deposited, flux.entering, 0.02 * flux.entering);
    // The floor's corners see the lamp past the cone.
    const MapData& floor = baked.maps.at(0);
    EXPECT_EQ(floor.irradiance.front(), 0);
    EXPECT_EQ(floor.irradiance.back(), 0);
}

TEST_F(FluxBalanceGLTest, farFromTheOriginNothingChanges) {
    Scene near = floorPastSphere();
    near.water.waves = {scenes::cosine(0.01, 0.32, {1, 0})};
    Scene far = near;
    // A whole number of wavelengths away, so that the waves are the same.
    for (Receiver& receiver : far.receivers)
        receiver.translation += glm::dvec3(320000, 0, 0);
    const Baked a = bake(near, true), b = bake(far, true);
    EXPECT_NEAR(a.flux[0].deposited, b.flux[0].deposited, 1e-3 * a.flux[0].deposited);
    EXPECT_NEAR(a.flux[0].entering, b.flux[0].entering, 1e-5 * a.flux[0].entering);
}

} // namespace
} // namespace limpid
