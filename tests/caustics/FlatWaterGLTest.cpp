#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/Optics.h"
#include "engine/EngineFixture.h"

namespace limpid {
namespace {

/// Flat water over a floor has a closed form: E · cosθ · T(θ) · exp(-K d / cosθr) everywhere.
struct FlatCase {
    double degrees;
    glm::dvec3 absorption;
    double depth;
};

class FlatWaterGLTest : public EngineGLTest, public ::testing::WithParamInterface<FlatCase> {};

TEST_P(FlatWaterGLTest, everyInnerTexelFollowsTheFormula) {
    const FlatCase& given = GetParam();
    const double cosine = std::cos(glm::radians(given.degrees));
    const double refracted = std::cos(std::asin(std::sin(glm::radians(given.degrees)) / 1.333));
    const double path = given.depth / refracted;
    const glm::dvec3 expected = glm::dvec3(2, 1, 0.5) * cosine *
                                optics::fresnelTransmittance(cosine, 1 / 1.333) *
                                optics::extinction(given.absorption, path);
    const struct {
        Method method;
        Fill fill;
        int planes;
    } runs[] = {{Method::LevelMapSmart, Fill::Drawn, 1},
                {Method::LevelMapSmart, Fill::Drawn, 50},
                {Method::LevelMapSmart, Fill::OnePass, 50},
                {Method::ExactBeam, Fill::OnePass, 1}};
    for (const auto& [method, fill, planes] : runs) {
        Scene scene;
        scene.receivers = {scenes::floorAt(-given.depth)};
        scene.lights = {scenes::sunAt(given.degrees)};
        scene.lights[0].irradiance = {2, 1, 0.5};
        scene.water.grid = {48, 48};
        scene.water.absorption = given.absorption;
        scene.caustics.mapSize = 200;
        scene.caustics.planes = planes;
        scene.caustics.method = method;
        scene.caustics.fill = fill;
        const Baked baked = bake(scene);
        const MapData& map = baked.maps.at(0);
        double worst = 0;
        int inner = 0;
        for (std::size_t i = 0; i < map.normalDotAxis.size(); ++i) {
            if (map.position[4 * i + 3] == 0) continue;
            if (std::max(std::abs(map.position[4 * i]), std::abs(map.position[4 * i + 2])) > 0.98f) continue;
            ++inner;
            for (int c = 0; c < 3; ++c)
                worst = std::max(worst,
                                 std::abs(double(map.irradiance[3 * i + std::size_t(c)]) / expected[c] - 1));
        }
        EXPECT_GT(inner, 10000);
        EXPECT_LT(worst, 0.005) << methodName(method) << ", " << fillName(fill) << ", " << planes
                                << " planes";
    }
}

INSTANTIATE_TEST_SUITE_P(angles, FlatWaterGLTest,
                         ::testing::Values(FlatCase{0, glm::dvec3(0), 1}, FlatCase{30, glm::dvec3(0), 1},
                                           FlatCase{60, glm::dvec3(0), 1}, FlatCase{80, glm::dvec3(0), 1},
                                           FlatCase{0, {0.5, 0.1, 0.02}, 1.5},
                                           FlatCase{30, {0.5, 0.1, 0.02}, 1.5},
                                           FlatCase{60, {0.5, 0.1, 0.02}, 1.5},
                                           FlatCase{80, {0.5, 0.1, 0.02}, 1.5}));

class CommensurableGridGLTest : public EngineGLTest {};

TEST_F(CommensurableGridGLTest, putsEachTexelIntoOneTriangle) {
    // 1024 cells on 512 texels put every texel's centre on a grid line; a sloppy rule for shared edges
    // doubles the light there.
    const std::pair<Method, Fill> ways[] = {{Method::LevelMapSmart, Fill::Drawn},
                                            {Method::LevelMapSmart, Fill::OnePass},
                                            {Method::ExactBeam, Fill::OnePass}};
    for (int run = 0; run < 9; ++run) {
        const int grid = 64 << run % 3;
        Scene scene;
        std::tie(scene.caustics.method, scene.caustics.fill) = ways[run / 3];
        scene.receivers = {scenes::floorAt(-1)};
        scene.lights = {scenes::sunAt(0)};
        scene.water.center = {0, 0};
        scene.water.size = {2, 2};
        scene.water.grid = glm::ivec2(grid);
        scene.caustics.mapSize = 64;
        const Baked baked = bake(scene);
        const double expected = optics::fresnelTransmittance(1.0, 1 / 1.333);
        for (std::size_t i = 0; i < baked.maps[0].irradiance.size(); ++i)
            ASSERT_NEAR(double(baked.maps[0].irradiance[i]) / expected, 1, 1e-3)
                << "texel " << i / 3 << ", grid " << grid;
    }
}

/// What every method must do.
class CausticMapGLTest : public EngineGLTest, public ::testing::WithParamInterface<Method> {
  protected:
    static Scene empty() {
        Scene scene;
        scene.caustics.method = GetParam();
        scene.caustics.photonGrid = {64, 64};
        return scene;
    }
};

TEST_P(CausticMapGLTest, everyTexelOfTheTargetIsWritten) {
    Engine engine(context());
    Scene scene = empty();
    scene.receivers = {scenes::shape("ball", makeSphere(0.5, glm::vec3(1)), {0, -1, 0})};
    scene.lights = {scenes::sunAt(0)};
    scene.water.grid = {16, 16};
    scene.caustics.mapSize = 64;
    const Baked first = bake(engine, scene);
    engine.setReuse(false);
    const glm::vec4 sentinel(-7);
    glClearTexImage(engine.maps()[0].caustics.irradiance.id(), 0, GL_RGBA, GL_FLOAT, &sentinel.x);
    glClearTexImage(engine.maps()[0].level.position.id(), 0, GL_RG, GL_FLOAT, &sentinel.x);
    glClearTexImage(engine.maps()[0].level.normal.id(), 0, GL_RG, GL_FLOAT, &sentinel.x);
    engine.updateCaustics(0);
    const MapData again = readMaps(engine.maps()[0], engine.origin());
    EXPECT_EQ(first.maps[0].irradiance, again.irradiance) << "the same bits after a sentinel";
    EXPECT_EQ(first.maps[0].position, again.position);
    const auto raw = engine.maps()[0].caustics.irradiance.readFloats(GL_RGBA, 4);
    EXPECT_TRUE(std::all_of(raw.begin(), raw.end(), [](float v) { return v >= 0; }));
}

TEST_P(CausticMapGLTest, twoLightsAddUp) {
    Scene scene = empty();
    scene.receivers = {scenes::floorAt(-1)};
    scene.water.grid = {32, 32};
    scene.caustics.mapSize = 64;
    scene.water.waves = {scenes::cosine(0.004, 0.3, {1, 0})};
    scene.lights = {scenes::sunAt(0, "one"), scenes::sunAt(0, "two")};
    const Baked baked = bake(scene);
    ASSERT_EQ(baked.maps.size(), 2u) << "a map for each light, eq. 4-20";
    EXPECT_EQ(baked.maps[0].irradiance, baked.maps[1].irradiance);
}

TEST_P(CausticMapGLTest, aLightThatDoesNotEnterGivesNothing) {
    Scene scene = empty();
    scene.receivers = {scenes::floorAt(-1)};
    scene.water.grid = {8, 8};
    scene.caustics.mapSize = 32;
    Light pointLight;
    pointLight.type = LightType::Point;
    pointLight.position = {0, -0.5, 0};
    scene.lights = {scenes::sunAt(100, "set"), pointLight};
    const Baked baked = bake(scene, true);
    for (const MapData& map : baked.maps)
        for (const float e : map.irradiance)
            EXPECT_EQ(e, 0);
    EXPECT_EQ(baked.flux[0].entering, 0);
    EXPECT_EQ(baked.flux[0].residual(), 0);
}

TEST_P(CausticMapGLTest, aPointLightOverFlatWaterIsBrightestBelowIt) {
    Scene scene = empty();
    scene.caustics.photonGrid = {200, 200};
    scene.receivers = {scenes::floorAt(-1)};
    scene.water.grid = {96, 96};
    scene.caustics.mapSize = 128;
    Light pointLight;
    pointLight.type = LightType::Point;
    pointLight.position = {0, 1, 0};
    scene.lights = {pointLight};
    const Baked baked = bake(scene);
    const MapData& map = baked.maps[0];
    const std::size_t center = 3 * (64 * 128 + 64);
    // On the axis flat water widens the solid angle as if the point light stood at n · (its height): E = I T
    // / (h + d/n)².
    const double expected = optics::fresnelTransmittance(1.0, 1 / 1.333) / std::pow(1 + 1 / 1.333, 2);
    EXPECT_NEAR(map.irradiance[center], expected, 0.01 * expected);
    EXPECT_GT(map.irradiance[center], map.irradiance[3 * (64 * 128 + 10)]);
}

INSTANTIATE_TEST_SUITE_P(methods, CausticMapGLTest,
                         ::testing::ValuesIn(allMethods().begin(), allMethods().end()),
                         [](const auto& method) {
                             std::string name(methodName(method.param));
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

} // namespace
} // namespace limpid
