#include <cmath>
#include <tuple>

#include "engine/EngineFixture.h"

namespace limpid {
namespace {

/// A pool of 4 m by 3 m, 1.5 m deep, sun at 40° along x: two walls run along the mean light.
class PoolGLTest : public EngineGLTest {
  protected:
    static Scene empty(bool waves) {
        Scene scene;
        scene.lights = {scenes::sunAt(40)};
        scene.water.level = -0.1;
        scene.water.grid = {128, 128};
        scene.caustics.mapSize = 384;
        scene.caustics.planes = 20;
        if (waves) scene.water.waves = {scenes::cosine(0.01, 0.5, {0.3, 1}), scenes::noise(0.008, 0.6)};
        return scene;
    }

    static Scene ofBoxes(bool waves) {
        Scene scene = empty(waves);
        const auto box = [](const char* name, const glm::dvec3& size, const glm::dvec3& at) {
            return scenes::shape(name, makeBox(size, glm::vec3(0.8f)), at);
        };
        scene.receivers = {
            box("floor", {4.4, 0.2, 3.4}, {0, -1.6, 0}), box("left", {0.2, 1.5, 3.4}, {-2.1, -0.75, 0}),
            box("right", {0.2, 1.5, 3.4}, {2.1, -0.75, 0}), box("back", {4, 1.5, 0.2}, {0, -0.75, -1.6}),
            box("front", {4, 1.5, 0.2}, {0, -0.75, 1.6})};
        return scene;
    }

    /// One mesh of floor and walls that stand 0.1 m out of the water, lit from aside, as files have it.
    static Scene ofOneMesh() {
        Mesh basin = makeBox({4, 1.2, 2}, glm::vec3(0.8f));
        std::vector<std::uint32_t> inside;
        for (std::size_t i = 0; i < basin.indices.size(); i += 3) {
            const auto [a, b, c] = std::tuple(basin.indices[i], basin.indices[i + 1], basin.indices[i + 2]);
            if (basin.normals[a].y < 0.5f) inside.insert(inside.end(), {a, c, b});
        }
        basin.indices = inside;
        basin.parts.front().indexCount = std::uint32_t(inside.size());
        for (glm::vec3& normal : basin.normals)
            normal = -normal;
        Scene scene = empty(true);
        scene.lights.front().direction = glm::normalize(glm::dvec3(0.3, -1, 0.1));
        scene.water.grid = {256, 256};
        scene.caustics.mapSize = 128;
        scene.caustics.method = Method::ExactBeam;
        scene.receivers = {scenes::shape("basin", basin, {0, -0.6, 0})};
        return scene;
    }

    static double onFurtherMaps(Engine& engine) {
        double sum = 0;
        for (const MapWork& maps : engine.maps())
            if (maps.level.facing > 0) sum += readMaps(maps, engine.origin()).deposited;
        return sum;
    }
};

TEST_F(PoolGLTest, balancesOnFloorAndWalls) {
    const FluxBalance flux = bake(ofBoxes(false), true).flux.at(0);
    EXPECT_LT(std::abs(flux.residual()), 0.01 * flux.entering) << flux.residual();
    EXPECT_LT(flux.rejected, 0.01 * flux.entering);
}

TEST_F(PoolGLTest, balancesUnderWaves) {
    // Beams are shaded in their own direction: what a wave throws on a wall along the light does not reach
    // the floor behind it as well.
    Engine& engine = sharedEngine();
    const FluxBalance flux = bake(engine, ofBoxes(true), true).flux.at(0);
    printf("residual under waves: %.3f %% of entering; walls along the light hold %.3f %%\n",
           100 * flux.residual() / flux.entering, 100 * onFurtherMaps(engine) / flux.entering);
    EXPECT_LT(std::abs(flux.residual()), 0.01 * flux.entering);
    EXPECT_LT(flux.rejected, 0.01 * flux.entering);
}

TEST_F(PoolGLTest, texelsAtTheWaterlineAndAtCreasesHoldTheirLight) {
    // 0.43 % were lost where such a texel's light was counted once more by the part that shows the wall.
    const FluxBalance flux = bake(ofOneMesh(), true).flux.at(0);
    printf("basin of one mesh: residual %.3f %%\n", 100 * flux.residual() / flux.entering);
    EXPECT_LT(std::abs(flux.residual()), 1e-3 * flux.entering);
}

TEST_F(PoolGLTest, aSheetInTheWatersOwnLevelIsLitWhereWavesRiseOverIt) {
    // 1.8 % too much came where they only rise over a part of a texel.
    Scene scene = ofOneMesh();
    scene.receivers.push_back(
        scenes::shape("sheet", makePlane({4, 2}, glm::vec3(0.8f)), {0, scene.water.level, 0}));
    const FluxBalance flux = bake(scene, true).flux.at(0);
    printf("sheet in the water's level: residual %.3f %%\n", 100 * flux.residual() / flux.entering);
    EXPECT_LT(std::abs(flux.residual()), 2.5e-3 * flux.entering);
}

TEST_F(PoolGLTest, wallsAlongTheLightAreLitByWavesAlone) {
    Engine& engine = sharedEngine();
    bake(engine, ofBoxes(false));
    const double calm = onFurtherMaps(engine);
    bake(engine, ofBoxes(true));
    const double rough = onFurtherMaps(engine);
    EXPECT_LT(calm, 1e-3) << "flat light only grazes them";
    EXPECT_GT(rough, 0.05);
}

TEST_F(PoolGLTest, bothSidesOfASheetHaveAMap) {
    Scene scene = empty(true);
    Receiver wall = scenes::shape("wall", makePlane({3, 1.2}, glm::vec3(0.8f)), {0, -0.8, 0});
    wall.rotation = glm::angleAxis(glm::radians(90.0), glm::dvec3(1, 0, 0));
    scene.receivers = {scenes::floorAt(-1.5, 4), wall};
    Engine& engine = sharedEngine();
    const Baked baked = bake(engine, scene, true);
    std::vector<double> sides;
    for (std::size_t i = 0; i < baked.maps.size(); ++i)
        if (engine.maps()[i].plan.receiver == 1 && engine.maps()[i].level.facing > 0)
            sides.push_back(baked.maps[i].deposited);
    ASSERT_EQ(sides.size(), 2u);
    EXPECT_GT(sides[0], 0.01);
    EXPECT_GT(sides[1], 0.01);
    EXPECT_LT(std::abs(baked.flux[0].residual()), 0.01 * baked.flux[0].entering);
}

TEST_F(PoolGLTest, roundThingsNeedNoFurtherMaps) {
    for (const char* name : {"sphere", "teapot"}) {
        Scene scene = empty(true);
        scene.receivers = {scenes::model(name, -1.5)};
        EXPECT_EQ(bake(scene).maps.size(), 1u) << name;
    }
    EXPECT_TRUE(isClosed(makeSphere(1, glm::vec3(1))));
    EXPECT_TRUE(isClosed(makeBox({1, 2, 3}, glm::vec3(1))));
    EXPECT_FALSE(isClosed(makePlane({1, 2}, glm::vec3(1))));
}

} // namespace
} // namespace limpid
