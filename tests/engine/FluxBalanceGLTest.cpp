#include <cmath>

#include "core/Optics.h"
#include "engine/EngineFixture.h"
#include "plan/PointLightPatch.h"

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
    /// Of what enters: the project's, and what chance may add in one of a thousand counts.
    static double most(const FluxBalance& flux) { return 0.001 + 3.3 * flux.standardError / flux.entering; }
};

TEST_F(FluxBalanceGLTest, floorPastASphereUnderFlatWater) {
    const Baked baked = bake(floorPastSphere(), true);
    const FluxBalance& flux = baked.flux.at(0);
    EXPECT_LT(share(flux), most(flux)) << flux.residual() << " W of " << flux.entering;
    EXPECT_LT(flux.rejected, 0.01 * flux.entering);
    EXPECT_GT(flux.missed, 0);
    EXPECT_LT(flux.standardError, 1.3 * FluxAudit::wantedError * flux.entering);

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
    EXPECT_LT(share(flux), most(flux));
    EXPECT_GT(flux.absorbed, 1.5 * flux.scattered);
    EXPECT_GT(flux.scattered, 0.05 * flux.entering);
}

TEST_F(FluxBalanceGLTest, underWaves) {
    Scene scene = floorPastSphere();
    scene.water.waves = {scenes::cosine(0.01, 0.3, {1, 0.4}), scenes::noise(0.01, 0.5)};
    const FluxBalance flux = bake(scene, true).flux.at(0);
    printf("residual under waves: %.3f %% of entering\n", 100 * flux.residual() / flux.entering);
    EXPECT_LT(share(flux), most(flux));
    EXPECT_LT(flux.rejected, 0.01 * flux.entering);
}

TEST_F(FluxBalanceGLTest, aPointLightNearTheWater) {
    Scene scene = floorPastSphere();
    Light pointLight;
    pointLight.type = LightType::Point;
    pointLight.position = {0.5, 0.6, 0.2};
    scene.lights = {pointLight};
    const FluxBalance flux = bake(scene, true).flux.at(0);
    EXPECT_LT(share(flux), most(flux)) << flux.residual() << " W of " << flux.entering;
}

/// A point light `above` flat water, of 1 W/sr, over a floor `below` it.
struct PointLightOverFloor {
    double above, below, ior;

    /// W/m² where light ends that leaves the point light at this angle from straight down: what a ring of the
    /// surface takes, over the ring of the floor that it lights.
    double irradiance(double angle) const {
        const double away = above * std::tan(angle), square = ior * ior;
        const double q = std::sqrt(square * above * above + (square - 1) * away * away);
        const double spread = (1 + below / q) * (1 + below * square * above * above / (q * q * q));
        const double share = optics::fresnelTransmittance(std::cos(angle), 1 / ior);
        return share * std::pow(std::cos(angle), 3) / (above * above) / spread;
    }
    double angleTo(double across) const {
        return std::atan(optics::flatCrossing(above, below, across, ior) / above);
    }
};

// A point light 1 mm above the water, whose quads are 60 mm wide: its beams begin in finer ones
// (plan/PointLightPatch.h).
TEST_F(FluxBalanceGLTest, aPointLightThatAlmostTouchesTheWater) {
    const PointLightOverFloor truth{0.001, 1, 1.333};
    Scene scene;
    scene.receivers = {scenes::floorAt(-1)};
    Light pointLight;
    pointLight.type = LightType::Point;
    pointLight.position = {0, truth.above, 0};
    scene.lights = {pointLight};
    scene.water.size = glm::dvec2(4);
    scene.water.grid = {64, 64};
    scene.caustics.mapSize = 128;
    const Baked baked = bake(scene, true);
    const FluxBalance& flux = baked.flux.at(0);
    EXPECT_LE(share(flux), most(flux));

    // All of the half-space below but what passes the patch, of which a point light so low sends 3e-4 of a
    // radian, at an angle where most is reflected. A mean of corners is wrong in the second order of what
    // turns between them.
    double entering = 0;
    const int rings = 10000;
    for (int i = 0; i < rings; ++i)
        entering += 2 * M_PI / rings * optics::fresnelTransmittance((i + 0.5) / rings, 1 / truth.ior);
    EXPECT_NEAR(flux.entering, entering, pointLightTurn * pointLightTurn / 8 * entering);

    // Each beam's light is even. Across one it should change as the closed form does across pointLightTurn;
    // what changes evenly is a quarter of that from its mean, on the mean.
    double difference = 0, most = 0;
    const MapData& map = baked.maps.at(0);
    for (std::size_t i = 0; i < map.normalDotAxis.size(); ++i) {
        const double across = std::hypot(map.position[4 * i], map.position[4 * i + 2]);
        const double angle = truth.angleTo(across), end = std::min(angle + 0.5 * pointLightTurn, 0.5 * M_PI);
        difference += std::abs(double(map.irradiance[3 * i]) - truth.irradiance(angle));
        most +=
            0.25 * std::abs(truth.irradiance(end) - truth.irradiance(std::abs(angle - 0.5 * pointLightTurn)));
    }
    EXPECT_LE(difference, most);
    printf(
        "close lamp: residual %.3f %%, entering %.3f %%, irradiance %.3f of what beams so wide may be off\n",
        100 * flux.residual() / flux.entering, 100 * (flux.entering / entering - 1), difference / most);
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
    EXPECT_LT(share(flux), most(flux)) << flux.residual() << " W of " << flux.entering;
    // All of the cone lands on floor and sphere.
    EXPECT_NEAR(flux.deposited, flux.entering, 0.02 * flux.entering);
    // The floor's corners see the point light past the cone.
    const MapData& floor = baked.maps.at(0);
    EXPECT_EQ(floor.irradiance.front(), 0);
    EXPECT_EQ(floor.irradiance.back(), 0);
}

/// Walls, floor and thin bars of one mesh, with texels as wide as a bar: light goes where faces are a texel
/// or two wide, and where they run along it. What no texel shows is rejected; the rest is in the maps.
TEST_F(FluxBalanceGLTest, thingsAsWideAsATexel) {
    Mesh mesh = makeBox({0.6, 0.5, 0.6}, glm::vec3(0.8f));
    const auto add = [&](const glm::dvec3& size, const glm::dvec3& at) {
        const Mesh bar = makeBox(size, glm::vec3(0.8f));
        const auto first = std::uint32_t(mesh.positions.size());
        for (std::size_t i = 0; i < bar.positions.size(); ++i) {
            mesh.positions.push_back(bar.positions[i] + at);
            mesh.normals.push_back(bar.normals[i]);
            mesh.uvs.push_back(bar.uvs[i]);
        }
        for (const std::uint32_t i : bar.indices)
            mesh.indices.push_back(first + i);
        mesh.parts[0].indexCount += int(bar.indices.size());
    };
    for (int i = 0; i < 6; ++i)
        add({0.02, 0.3, 0.02}, {-0.8 + 0.07 * i, 0, 0.5});
    Scene scene;
    scene.receivers = {scenes::shape("yard", std::move(mesh), {0, -0.8, 0})};
    scene.water.waves = {scenes::cosine(0.01, 0.3, {1, 0.4})};
    scene.water.grid = {96, 96};
    scene.caustics.mapSize = 64;
    for (const double degrees : {2.0, 12.0}) {
        scene.lights = {scenes::sunAt(degrees)};
        const FluxBalance flux = bake(scene, true).flux.at(0);
        printf("bars, sun at %g°: residual %.3f %%, rejected %.3f %%, deposited %.3f %% of entering\n",
               degrees, 100 * flux.residual() / flux.entering, 100 * flux.rejected / flux.entering,
               100 * flux.deposited / flux.entering);
        EXPECT_LT(share(flux), most(flux)) << degrees;
        EXPECT_GT(flux.rejected, 0) << degrees;
    }
}

TEST_F(FluxBalanceGLTest, coarseWater) {
    Scene scene = floorPastSphere();
    scene.water.waves = {scenes::cosine(0.01, 0.5, {1, 0.4})};
    scene.caustics.mapSize = 128;
    for (const int cells : {4, 12, 40}) {
        scene.water.grid = glm::ivec2(cells);
        const FluxBalance flux = bake(scene, true).flux.at(0);
        EXPECT_LT(share(flux), most(flux)) << cells << ": " << flux.residual() << " W of " << flux.entering;
    }
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
