#include "io/toml/SceneFile.h"

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/SmallGltf.h"
#include "io/TempFolder.h"

namespace limpid::io {
namespace {

using test::TempFolder;
using test::triangleGltf;

constexpr std::string_view smallest = "[[receiver]]\nplane = { size = [2, 2] }\n";

Scene load(const std::string& text, const std::vector<Override>& overrides = {}) {
    const TempFolder folder;
    return loadScene(folder.write("scene.toml", text), overrides);
}

TEST(SceneFileTest, TheSmallestSceneHasAllDefaults) {
    const Scene scene = load(std::string(smallest));
    const Scene defaults;
    EXPECT_FALSE(scene.camera.position);
    EXPECT_FALSE(scene.water.size);
    EXPECT_EQ(scene.water.grid, defaults.water.grid);
    EXPECT_EQ(scene.water.ior, 1.333);
    EXPECT_TRUE(scene.lights.empty());
    EXPECT_EQ(scene.skyRadiance, defaults.skyRadiance);
    EXPECT_EQ(scene.caustics.method, defaults.caustics.method);
    ASSERT_EQ(scene.receivers.size(), 1u);
    EXPECT_EQ(scene.receivers[0].name, "receiver0");
    EXPECT_EQ(scene.receivers[0].scale, glm::dvec3(1));
    EXPECT_EQ(scene.receivers[0].mesh->materials[0].baseColor, glm::vec4(0.8f, 0.8f, 0.8f, 1));
}

constexpr std::string_view full = R"(
[camera]
position = [0, 1.5, 2.5]
target = [0, -0.5, 0]
up = [0, 0, 1]
vertical_fov = 30
exposure = -1.5
[water]
level = 0.25
center = [1, 2]
size = [3, 4]
grid = [64, 32]
ior = 1.5
absorption = [0.1, 0.2, 0.3]
scattering = [1, 2, 3]
anisotropy = -0.5
[[water.wave]]
type = "cosine"
amplitude = 0.01
wavelength = 0.5
direction = [0, 2]
speed = 0.75
phase = 90
[[water.wave]]
type = "circular"
center = [5, 6]
[[water.wave]]
type = "noise"
octaves = 3
seed = 4294967295
[[light]]
name = "sun"
direction = [1, -2, 0]
irradiance = [3, 2, 1]
angular_diameter = 0.53
[[light]]
type = "point"
position = [1, 2, 3]
intensity = [4, 5, 6]
[[light]]
type = "spot"
position = [1, 2, 3]
direction = [0, -2, 1]
inner_cone = 10
outer_cone = 20
[[receiver]]
name = "floor"
plane = { size = [2, 3] }
translation = [0, -1, 0]
rotation = [0, 2, 0, 0]
scale = [1, -2, 1]
albedo = [0.1, 0.2, 0.3]
[[receiver]]
sphere = { radius = 0.5 }
[[receiver]]
box = { size = [1, 2, 3] }
[sky]
radiance = [1, 2, 3]
[ambient]
radiance = [4, 5, 6]
[caustics]
method = "level-map"
map_size = 1024
planes = 7
fill = "drawn"
slicing = "levels"
depth_levels = 10
threshold = 0.5
[godrays]
method = "none"
)";

TEST(SceneFileTest, ReadsCameraAndWater) {
    const Scene scene = load(std::string(full));
    EXPECT_EQ(scene.camera.position, glm::dvec3(0, 1.5, 2.5));
    EXPECT_EQ(scene.camera.target, glm::dvec3(0, -0.5, 0));
    EXPECT_EQ(scene.camera.up, glm::dvec3(0, 0, 1));
    EXPECT_EQ(scene.camera.verticalFov, 30);
    EXPECT_EQ(scene.camera.exposure, -1.5);
    EXPECT_EQ(scene.water.level, 0.25);
    EXPECT_EQ(scene.water.center, glm::dvec2(1, 2));
    EXPECT_EQ(scene.water.size, glm::dvec2(3, 4));
    EXPECT_EQ(scene.water.grid, glm::ivec2(64, 32));
    EXPECT_EQ(scene.water.ior, 1.5);
    EXPECT_EQ(scene.water.absorption, glm::dvec3(0.1, 0.2, 0.3));
    EXPECT_EQ(scene.water.scattering, glm::dvec3(1, 2, 3));
    EXPECT_EQ(scene.water.anisotropy, -0.5);
}

TEST(SceneFileTest, ReadsWaves) {
    const std::vector<Wave> waves = load(std::string(full)).water.waves;
    ASSERT_EQ(waves.size(), 3u);
    EXPECT_EQ(waves[0].type, WaveType::Cosine);
    EXPECT_EQ(waves[0].amplitude, 0.01);
    EXPECT_EQ(waves[0].wavelength, 0.5);
    EXPECT_EQ(waves[0].direction, glm::dvec2(0, 2));
    EXPECT_EQ(waves[0].speed, 0.75);
    EXPECT_EQ(waves[0].phase, 90);
    EXPECT_EQ(waves[1].type, WaveType::Circular);
    EXPECT_EQ(waves[1].center, glm::dvec2(5, 6));
    EXPECT_EQ(waves[2].type, WaveType::Noise);
    EXPECT_EQ(waves[2].octaves, 3);
    EXPECT_EQ(waves[2].seed, 4294967295u);
}

TEST(SceneFileTest, ReadsLightsSkyAndSettings) {
    const Scene scene = load(std::string(full));
    ASSERT_EQ(scene.lights.size(), 3u);
    EXPECT_EQ(scene.lights[0].name, "sun");
    EXPECT_EQ(scene.lights[0].direction, glm::dvec3(1, -2, 0));
    EXPECT_EQ(scene.lights[0].irradiance, glm::dvec3(3, 2, 1));
    EXPECT_EQ(scene.lights[0].angularDiameter, 0.53);
    EXPECT_EQ(scene.lights[1].name, "light1");
    EXPECT_EQ(scene.lights[1].type, LightType::Point);
    EXPECT_EQ(scene.lights[1].position, glm::dvec3(1, 2, 3));
    EXPECT_EQ(scene.lights[1].intensity, glm::dvec3(4, 5, 6));
    EXPECT_FALSE(scene.lights[1].isSpot());
    EXPECT_TRUE(scene.lights[2].isSpot());
    EXPECT_EQ(scene.lights[2].direction, glm::dvec3(0, -2, 1));
    EXPECT_EQ(scene.lights[2].innerCone, 10);
    EXPECT_EQ(scene.lights[2].outerCone, 20);
    EXPECT_EQ(scene.skyRadiance, glm::dvec3(1, 2, 3));
    EXPECT_EQ(scene.ambientRadiance, glm::dvec3(4, 5, 6));
    EXPECT_EQ(scene.caustics.method, Method::LevelMap);
    EXPECT_EQ(scene.caustics.mapSize, 1024);
    EXPECT_EQ(scene.caustics.planes, 7);
    EXPECT_EQ(scene.caustics.fill, Fill::Drawn);
    EXPECT_EQ(scene.caustics.slicing, Slicing::Levels);
    EXPECT_EQ(scene.caustics.depthLevels, 10);
    EXPECT_EQ(scene.caustics.threshold, 0.5);
}

TEST(SceneFileTest, ReadsReceivers) {
    const std::vector<Receiver> receivers = load(std::string(full)).receivers;
    ASSERT_EQ(receivers.size(), 3u);
    EXPECT_EQ(receivers[0].name, "floor");
    EXPECT_EQ(receivers[0].mesh->triangleCount(), 2u);
    EXPECT_EQ(receivers[0].mesh->materials[0].baseColor, glm::vec4(0.1f, 0.2f, 0.3f, 1));
    EXPECT_EQ(receivers[0].translation, glm::dvec3(0, -1, 0));
    EXPECT_EQ(receivers[0].rotation, glm::dquat(0, 0, 1, 0)) << "normalised";
    EXPECT_EQ(receivers[0].scale, glm::dvec3(1, -2, 1));
    EXPECT_EQ(receivers[1].mesh->triangleCount(), 1984u);
    EXPECT_EQ(receivers[2].mesh->triangleCount(), 12u);
}

TEST(SceneFileTest, ModelsAreRelativeToTheSceneFileAndLoadedOnce) {
    const TempFolder folder;
    const auto model = folder.write("models/fish.gltf", triangleGltf().text());
    const auto file = folder.write("scenes/scene.toml", R"(
[[receiver]]
gltf = "../models/fish.gltf"
[[receiver]]
gltf = "../scenes/../models/fish.gltf"
translation = [1, 0, 0]
[[receiver]]
gltf = ")" + model.string() + "\"\n");
    const Scene scene = loadScene(file);
    ASSERT_EQ(scene.receivers.size(), 3u);
    EXPECT_EQ(scene.receivers[0].mesh->triangleCount(), 1u);
    EXPECT_EQ(scene.receivers[0].mesh, scene.receivers[1].mesh);
    EXPECT_EQ(scene.receivers[0].mesh, scene.receivers[2].mesh);
}

TEST(OverrideTest, ReachesEveryKind) {
    const Scene scene = load(std::string(full), {{"camera.exposure", "2"},
                                                 {"water.wave.0.amplitude", "0.5"},
                                                 {"water.wave.2.seed", "5"},
                                                 {"light.sun.direction", "[0, -1, 0]"},
                                                 {"light.light1.intensity", "[1, 1, 1]"},
                                                 {"light.1.position", "[9, 9, 9]"},
                                                 {"receiver.floor.plane.size", "[8, 8]"},
                                                 {"caustics.method", "level-map-smart"},
                                                 {"caustics.planes", "3"},
                                                 {"caustics.planes", "4"}});
    EXPECT_EQ(scene.camera.exposure, 2);
    EXPECT_EQ(scene.water.waves[0].amplitude, 0.5);
    EXPECT_EQ(scene.water.waves[2].seed, 5u);
    EXPECT_EQ(scene.lights[0].direction, glm::dvec3(0, -1, 0));
    EXPECT_EQ(scene.lights[1].intensity, glm::dvec3(1));
    EXPECT_EQ(scene.lights[1].position, glm::dvec3(9));
    EXPECT_EQ(worldBounds(scene.receivers[0]).size().x, 8);
    EXPECT_EQ(scene.caustics.method, Method::LevelMapSmart);
    EXPECT_EQ(scene.caustics.planes, 4) << "the last one counts";
}

TEST(OverrideTest, MakesTablesThatTheFileHasNot) {
    const Scene scene =
        load(std::string(smallest), {{"camera.exposure", "1"}, {"sky.radiance", "[0, 0, 0]"}});
    EXPECT_EQ(scene.camera.exposure, 1);
    EXPECT_EQ(scene.skyRadiance, glm::dvec3(0));
}

TEST(OverrideTest, TheLongestNameWinsAmongNamesWithDots) {
    const std::string text =
        std::string(smallest) + "name = 'a'\n[[receiver]]\nname = 'a.b'\nbox = { size = [1, 1, 1] }\n";
    const Scene scene = load(text, {{"receiver.a.b.scale", "[2, 2, 2]"}, {"receiver.a.scale", "[3, 3, 3]"}});
    EXPECT_EQ(scene.receivers[0].scale, glm::dvec3(3));
    EXPECT_EQ(scene.receivers[1].scale, glm::dvec3(2));
}

TEST(PresetTest, EachIsWater) {
    for (const char* preset :
         {"calm pool", "breeze", "rain drops", "circular + noise", "cosine + strong noise"}) {
        const auto wavesAt = [&](const char* center) {
            return load(std::string(smallest) + "[water]\ncenter = " + center + "\npreset = \"" + preset +
                        "\"\n")
                .water.waves;
        };
        const std::vector<Wave> waves = wavesAt("[0, 0]"), moved = wavesAt("[10, 20]");
        ASSERT_GE(waves.size(), 2u) << preset;
        double height = 0, slope = 0;
        for (std::size_t i = 0; i < waves.size(); ++i) {
            height += waves[i].amplitude;
            slope += 2 * std::numbers::pi * waves[i].amplitude / waves[i].wavelength;
            EXPECT_GT(waves[i].speed, 0.23) << "no wave on water is slower";
            if (waves[i].type == WaveType::Circular) {
                EXPECT_EQ(moved[i].center, waves[i].center + glm::dvec2(10, 20));
            }
        }
        EXPECT_LT(height, 0.03) << preset;
        EXPECT_GT(slope, 0.05) << preset << ": caustics";
        EXPECT_LT(slope, 0.4) << preset << ": and not a storm";
    }
    const std::vector<Wave> drops =
        load(std::string(smallest) + "[water]\npreset = 'rain drops'\n").water.waves;
    ASSERT_EQ(drops.size(), 12u);
    EXPECT_NE(drops[0].center, drops[1].center);
    const std::string scaled = std::string(smallest) + "[water]\npreset = 'rain drops'\nwave_scale = 2\n";
    EXPECT_EQ(load(scaled).water.waves[3].amplitude, 2 * drops[3].amplitude);
}

TEST(SceneFileTest, WatersHaveTheirColours) {
    const auto waterOf = [](const std::string& text) {
        return load(std::string(smallest) + "[water]\n" + text).water;
    };
    EXPECT_EQ(waterOf("").scattering, glm::dvec3(0));
    const Water ocean = waterOf("type = 'clear ocean'"), coast = waterOf("type = 'coastal'");
    EXPECT_GT(ocean.absorption.r, 10 * ocean.absorption.b) << "blue";
    EXPECT_GT(coast.absorption.b, coast.absorption.g) << "green";
    EXPECT_NEAR(ocean.scattering.g, 0.037 * 514 / 550, 1e-12);
    EXPECT_NEAR(coast.scattering.b / ocean.scattering.b, 0.219 / 0.037, 1e-12);
    EXPECT_EQ(coast.anisotropy, 0.924);
    const Water own = waterOf("type = 'pool'\nabsorption = [1, 2, 3]\nanisotropy = 0.5");
    EXPECT_EQ(own.absorption, glm::dvec3(1, 2, 3)) << "keys beside it count more";
    EXPECT_EQ(own.anisotropy, 0.5);
    EXPECT_GT(own.scattering.r, 0);
}

struct ModelCase {
    const char* file;
    std::vector<float> positions;
    const char* name;
    double size; ///< what lengths are measured by
};

class ModelAloneTest : public testing::TestWithParam<ModelCase> {};

TEST_P(ModelAloneTest, GetsFloorWaterAndSunInProportion) {
    const TempFolder folder;
    test::SmallGltf gltf;
    gltf.addMesh({{"attributes", {{"POSITION", gltf.add("VEC3", GetParam().positions)}}}});
    const Scene scene = loadScene(folder.write(GetParam().file, gltf.text()));
    const double s = GetParam().size;
    ASSERT_EQ(scene.receivers.size(), 2u);
    EXPECT_EQ(scene.receivers[0].name, GetParam().name);
    EXPECT_EQ(scene.receivers[1].name, "floor");
    const Bounds model = worldBounds(scene.receivers[0]), floor = worldBounds(scene.receivers[1]);
    EXPECT_NEAR(floor.size().x, 6.5 * s, 1e-9 * s);
    EXPECT_NEAR(floor.size().z, 6.5 * s, 1e-9 * s);
    EXPECT_NEAR(floor.center().x, model.center().x, 1e-9 * s);
    EXPECT_NEAR(floor.center().z, model.center().z, 1e-9 * s);
    EXPECT_LT(floor.max.y, model.min.y);
    EXPECT_GT(floor.max.y, model.min.y - 0.01 * s);
    EXPECT_NEAR(scene.water.level, model.max.y + 0.6 * s, 1e-9 * s);
    EXPECT_NEAR(scene.water.absorption.x * s, 0.3, 1e-9);
    ASSERT_EQ(scene.lights.size(), 1u);
    EXPECT_EQ(scene.lights[0].name, "sun");
    EXPECT_NEAR(glm::length(scene.lights[0].direction), 1, 1e-12);
    EXPECT_FALSE(scene.camera.position);
    EXPECT_FALSE(scene.water.size);
    ASSERT_EQ(scene.water.waves.size(), 3u);
    for (const Wave& wave : scene.water.waves) {
        EXPECT_LT(wave.amplitude, 0.05 * s);
        EXPECT_NEAR(wave.speed, std::sqrt(9.81 * wave.wavelength / (2 * std::numbers::pi)), 1e-9);
    }
}

INSTANTIATE_TEST_SUITE_P(
    All, ModelAloneTest,
    testing::Values(ModelCase{"fish.gltf", {0, 0, 0, 2, 0, 0, 0, 1, 1}, "fish", 2},
                    ModelCase{"My Fish (1).GLTF", {10, 5, 0, 10, 5, 0.5, 10.25, 5, 0}, "My_Fish__1_", 0.5},
                    ModelCase{"floor.gltf", {0, 0, 0, 1, 0, 0, 0, 1, 0}, "model", 1},
                    ModelCase{"\xc3\xa9.gltf", {0, 0, 0, 1, 0, 0, 0, 1, 0}, "model", 1},
                    ModelCase{"point.gltf", {3, 3, 3, 3, 3, 3, 3, 3, 3}, "point", 1},
                    ModelCase{"small.gltf", {0, 0, 0, 1e-3f, 0, 0, 0, 1e-3f, 0}, "small", 1e-3f},
                    ModelCase{"large.gltf", {0, 0, 0, 1e8f, 0, 0, 0, 1e8f, 0}, "large", 1e8f}));

TEST(ModelAloneOverrideTest, ReachesTheEntriesMadeForIt) {
    const TempFolder folder;
    const auto file = folder.write("fish.glb", triangleGltf().glb());
    const Scene scene = loadScene(file, {{"light.sun.irradiance", "[1, 1, 1]"},
                                         {"receiver.fish.translation", "[0, 1, 0]"},
                                         {"receiver.floor.plane.size", "[9, 9]"},
                                         {"water.wave.2.seed", "7"},
                                         {"camera.position", "[1, 2, 3]"}});
    EXPECT_EQ(scene.lights[0].irradiance, glm::dvec3(1));
    EXPECT_EQ(worldBounds(scene.receivers[0]).min.y, 1);
    EXPECT_EQ(worldBounds(scene.receivers[1]).size().x, 9);
    EXPECT_EQ(scene.water.waves[2].seed, 7u);
    EXPECT_EQ(scene.camera.position, glm::dvec3(1, 2, 3));
}

TEST(ModelAloneOverrideTest, APresetTakesThePlaceOfItsWaves) {
    const TempFolder folder;
    const auto file = folder.write("fish.glb", triangleGltf().glb());
    EXPECT_EQ(loadScene(file, {{"water.preset", "rain drops"}}).water.waves.size(), 12u);
    EXPECT_EQ(
        test::errorOf(folder,
                      [&] {
                          loadScene(file, {{"water.preset", "breeze"}, {"water.wave.0.amplitude", "1"}});
                      }),
        "--set water.preset=breeze: expected no preset beside the waves of [[water.wave]], found \"breeze\"");
}

} // namespace
} // namespace limpid::io
