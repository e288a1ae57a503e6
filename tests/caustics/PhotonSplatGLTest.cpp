#include "caustics/PhotonSplat.h"

#include <cmath>

#include "caustics/CosineTruth.h"
#include "engine/EngineFixture.h"

namespace limpid {
namespace {

struct Setting {
    int grid, subdivision;
    glm::dvec2 splat;
    int taps;
};

void apply(const Setting& setting, CausticsSettings& caustics) {
    caustics.method = Method::PhotonSplat;
    caustics.photonGrid = glm::ivec2(setting.grid);
    caustics.photonSubdivision = setting.subdivision;
    caustics.splatSize = setting.splat;
    caustics.filterTaps = setting.taps;
}

class PhotonSplatGLTest : public EngineGLTest {
  protected:
    static Scene cosineScene() {
        Scene scene;
        scene.receivers = {scenes::floorAt(-1, 1)};
        scene.lights = {scenes::sunAt(0)};
        scene.water.waves = {scenes::cosine(0.004, 0.2, {1, 0})};
        scene.water.center = glm::dvec2(0);
        scene.water.size = glm::dvec2(1.09);
        scene.water.grid = glm::ivec2(512);
        scene.caustics.mapSize = 256;
        return scene;
    }
    static Scene floorPastSphere() {
        Scene scene = scenes::floorPastSphere(45);
        scene.water.waves = {scenes::cosine(0.01, 0.3, {1, 0.4}), scenes::noise(0.01, 0.5)};
        scene.caustics.mapSize = 192;
        return scene;
    }
};

TEST(SplatSizes, areTheSettingsAtBothEnds) {
    // Papadopoulos 3.3: s = a + b / d.
    const auto size = [](const glm::dvec2& ab, double d) { return ab.x + ab.y / d; };
    const glm::dvec2 ab = splatSizes({5, 20}, 0.5, 4);
    EXPECT_NEAR(size(ab, 0.5), 20, 1e-12);
    EXPECT_NEAR(size(ab, 4), 5, 1e-12);
    EXPECT_EQ(splatSizes({5, 20}, 2, 2), glm::dvec2(5, 0)) << "one distance only";
    EXPECT_NEAR(size(splatSizes({2, 10}, 0, 3), 3), 2, 1e-12) << "what touches the water";
}

TEST_F(PhotonSplatGLTest, convergesToOneCosineWave) {
    // With four times the photons and half the splat, the error is less than 0.75 times as large: it would be
    // half if the caustic had no edges, and an edge is blurred over a texel at least.
    const auto truth = CosineTruth{}.texels(-0.5, 256, 256);
    double before = 1;
    for (const Setting& setting : {Setting{128, 2, {8, 8}, 0}, Setting{256, 2, {4, 4}, 0},
                                   Setting{256, 4, {2, 2}, 0}, Setting{256, 8, {1, 1}, 0}}) {
        Scene scene = cosineScene();
        apply(setting, scene.caustics);
        const MapData map = bake(scene).maps.at(0);
        ASSERT_EQ(map.size, glm::ivec2(256));
        double error = 0, sum = 0, whole = 0;
        for (std::size_t i = 0; i < 256 * 256; ++i) {
            error += std::abs(double(map.irradiance[3 * i]) - truth[i % 256]);
            sum += double(map.irradiance[3 * i]);
            whole += truth[i % 256];
        }
        printf("%d² photons, splats of %.0f: nMAE %.2f %%, flux ratio %.5f\n",
               setting.grid * setting.subdivision, setting.splat.x, 100 * error / whole, sum / whole);
        EXPECT_LT(error / whole, 0.75 * before);
        // At each of two edges a column of photons is in or out.
        EXPECT_NEAR(sum / whole, 1, 2 * 1.09 / (setting.grid * setting.subdivision));
        before = error / whole;
    }
    EXPECT_LT(before, 0.05);
}

TEST_F(PhotonSplatGLTest, hasTheFluxOfExactBeamsAtAnySetting) {
    Scene scene = floorPastSphere();
    Engine& engine = sharedEngine();
    const Baked exact = bake(engine, scene);
    double least = 1e300, most = 0;
    for (const Setting& setting : {Setting{200, 2, {5, 20}, 8}, Setting{100, 1, {2, 10}, 0},
                                   Setting{60, 4, {1, 1}, 32}, Setting{80, 2, {40, 40}, 3}}) {
        apply(setting, scene.caustics);
        const Baked baked = bake(engine, scene, true);
        // The sphere is 96 texels wide here, and exact beams leave out the half of a texel all around that it
        // does not fill: 1 %.
        EXPECT_NEAR(baked.maps[0].deposited, exact.maps[0].deposited, 0.005 * exact.maps[0].deposited);
        EXPECT_NEAR(baked.maps[1].deposited, exact.maps[1].deposited, 0.015 * exact.maps[1].deposited);
        least = std::min(least, baked.maps[1].deposited);
        most = std::max(most, baked.maps[1].deposited);
        const FluxBalance& flux = baked.flux.at(0);
        printf("residual %.3f %%, sphere %.2f %%, floor %.2f %%\n", 100 * flux.residual() / flux.entering,
               100 * (baked.maps[1].deposited / exact.maps[1].deposited - 1),
               100 * (baked.maps[0].deposited / exact.maps[0].deposited - 1));
        EXPECT_LT(std::abs(flux.residual()), 0.01 * flux.entering);
    }
    // The coarsest grid has 100 photons a side over the water that lights the sphere; half of one, at its
    // edge, is in or out.
    EXPECT_LT(most - least, 0.5 / 100 * most);
}

TEST_F(PhotonSplatGLTest, oneGridOverAllWaterLightsEachReceiver) {
    Scene scene = floorPastSphere();
    Engine& engine = sharedEngine();
    const Baked exact = bake(engine, scene, true);
    apply({400, 1, {2, 2}, 0}, scene.caustics);
    scene.caustics.photonGridOver = PhotonGridOver::Water;
    const Baked baked = bake(engine, scene, true);
    const double photons = exact.maps[1].deposited / exact.flux.at(0).entering * 400 * 400;
    const double across = std::sqrt(photons * 4 / glm::pi<double>());
    printf("%.0f photons across the sphere, sphere %.2f %%, floor %.2f %%, residual %.3f %%\n", across,
           100 * (baked.maps[1].deposited / exact.maps[1].deposited - 1),
           100 * (baked.maps[0].deposited / exact.maps[0].deposited - 1),
           100 * baked.flux.at(0).residual() / baked.flux.at(0).entering);
    // Half a photon all around is in or out.
    EXPECT_NEAR(baked.maps[1].deposited, exact.maps[1].deposited, 2 / across * exact.maps[1].deposited);
    EXPECT_NEAR(baked.maps[0].deposited, exact.maps[0].deposited, 0.01 * exact.maps[0].deposited);
    // One photon lands on the sphere or beside it: what either gets the other does not.
    EXPECT_LT(std::abs(baked.flux.at(0).residual()), 0.01 * baked.flux.at(0).entering);
}

TEST_F(PhotonSplatGLTest, landsOnTheTopOrOnAWall) {
    // Seen askew, the walls of a block show without its top: a photon that went in there must not be found
    // again as one that came upon a wall from beside. (On a fish, side maps had a hundred times their
    // light so.)
    Scene scene;
    scene.receivers = {scenes::shape("block", makeBox({0.6, 0.5, 0.4}, glm::vec3(0.8f)), {0, -0.8, 0})};
    scene.lights = {scenes::sunAt(0)};
    scene.water.waves = {scenes::cosine(0.012, 0.4, {1, 0.3}), scenes::cosine(0.01, 0.3, {-0.4, 1})};
    scene.water.grid = {96, 96};
    scene.caustics.mapSize = 120;
    Engine& engine = sharedEngine();
    scene.caustics.method = Method::ExactBeam;
    const Baked exact = bake(engine, scene);
    apply({200, 2, {2, 2}, 0}, scene.caustics);
    const Baked baked = bake(engine, scene);
    ASSERT_EQ(baked.maps.size(), 5u) << "the top and four walls";
    const double wall = baked.maps[2].deposited, opposite = baked.maps[4].deposited;
    printf("top %.4f of exact beams', wall %.4f, the one opposite %.4f of it\n",
           baked.maps[0].deposited / exact.maps[0].deposited, wall / exact.maps[2].deposited,
           opposite / wall);
    // Photons are 400 a side over the light's part of the water; half of one, at each edge, is in or out. A
    // wall gets what a strip along it gets, some 20 photons wide: 1 in 20. The waves are even about the
    // block's middle, so that opposite walls get the same.
    EXPECT_NEAR(baked.maps[0].deposited, exact.maps[0].deposited, 0.01 * exact.maps[0].deposited);
    EXPECT_NEAR(wall, exact.maps[2].deposited, 0.05 * wall);
    EXPECT_NEAR(opposite, wall, 0.05 * wall);
}

TEST_F(PhotonSplatGLTest, everyRunGivesTheSameBits) {
    Scene scene = floorPastSphere();
    scene.caustics.method = Method::PhotonSplat;
    scene.water.absorption = {0.4, 0.1, 0.05};
    const Baked a = bakeAfresh(scene), b = bakeAfresh(scene);
    for (std::size_t i = 0; i < a.maps.size(); ++i)
        EXPECT_EQ(a.maps[i].irradiance, b.maps[i].irradiance);
}

TEST_F(PhotonSplatGLTest, absorbsByColour) {
    Scene scene = cosineScene();
    scene.water.waves.clear();
    scene.water.absorption = {0.5, 0.25, 0};
    scene.caustics.mapSize = 64;
    apply({128, 2, {2, 2}, 4}, scene.caustics);
    const MapData map = bake(scene).maps.at(0);
    const std::size_t middle = 3 * (32 * 64 + 32);
    EXPECT_NEAR(map.irradiance[middle] / map.irradiance[middle + 2], std::exp(-0.5), 1e-3);
    EXPECT_NEAR(map.irradiance[middle + 1] / map.irradiance[middle + 2], std::exp(-0.25), 1e-3);
}

} // namespace
} // namespace limpid
