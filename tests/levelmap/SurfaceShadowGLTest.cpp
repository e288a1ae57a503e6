#include "levelmap/SurfaceShadow.h"

#include <cmath>

#include "core/Optics.h"
#include "engine/EngineFixture.h"

namespace limpid {
namespace {

/// A ball half out of the water takes its disc from the light before the surface does.
class SurfaceShadowGLTest : public EngineGLTest {
  protected:
    static Scene ballInWater(double degrees) {
        Scene scene;
        scene.receivers = {scenes::floorAt(-1, 4),
                           scenes::shape("ball", makeSphere(0.5, glm::vec3(1)), {0, 0.1, 0})};
        scene.lights = {scenes::sunAt(degrees)};
        scene.water.center = {0, 0};
        scene.water.size = {5, 5};
        scene.water.grid = {128, 128};
        scene.caustics.mapSize = 256;
        return scene;
    }
};

TEST_F(SurfaceShadowGLTest, whatStandsOutTakesItsDiscFromTheWater) {
    const double through = optics::fresnelTransmittance(1.0, 1 / 1.333);
    const FluxBalance flux = bake(ballInWater(0), true).flux.at(0);
    // The disc of a sphere of 32 flat sides: its silhouette is a polygon of 32 corners.
    const double disc = 16 * 0.25 * std::sin(2 * M_PI / 32);
    EXPECT_NEAR(flux.entering / through, 25 - disc, 0.005);
    EXPECT_LT(std::abs(flux.residual()), 0.01 * flux.entering);
}

TEST_F(SurfaceShadowGLTest, anObliqueShadowIsLonger) {
    // At 45° a ball that touches nothing but air casts an ellipse, 1/cos longer; projected back it is the
    // disc again.
    Scene scene = ballInWater(45);
    scene.receivers[1].translation.y = 0.8;
    const double cosine = std::cos(M_PI / 4);
    const double through = optics::fresnelTransmittance(cosine, 1 / 1.333);
    const FluxBalance flux = bake(scene, true).flux.at(0);
    EXPECT_NEAR(flux.entering / through, 25 * cosine - 16 * 0.25 * std::sin(2 * M_PI / 32), 0.01);
}

TEST_F(SurfaceShadowGLTest, noCausticAboveTheWater) {
    Engine& engine = sharedEngine();
    const Baked baked = bake(engine, ballInWater(0));
    const MapData& ball = baked.maps.at(1);
    for (std::size_t i = 0; i < ball.normalDotAxis.size(); ++i)
        if (ball.position[4 * i + 3] > 0) {
            EXPECT_LE(ball.position[4 * i + 1], 1e-5f);
        }
    // Under a vertical sun the ball's own shade covers all of it that is wet.
    EXPECT_LT(ball.deposited, 0.01 * baked.maps[0].deposited);
}

TEST_F(SurfaceShadowGLTest, withoutAnythingAboveThereIsNoMap) {
    Engine& engine = sharedEngine();
    Scene scene = ballInWater(0);
    scene.receivers.pop_back();
    bake(engine, scene);
    EXPECT_EQ(context().ledger().bytes("surface shadow map"), 0);
}

} // namespace
} // namespace limpid
