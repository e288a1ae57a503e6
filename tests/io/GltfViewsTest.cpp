#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/SmallGltf.h"
#include "io/TempFolder.h"
#include "io/gltf/Gltf.h"
#include "io/toml/SceneFile.h"

namespace limpid::io {
namespace {

using nlohmann::json;
using test::errorOf;
using test::SmallGltf;
using test::TempFolder;
using test::triangleGltf;
using testing::HasSubstr;

constexpr double tolerance = 1e-9;
const double half = std::sqrt(0.5);

/// Turns −z, where lights and cameras look, straight down.
const json down = {-half, 0, 0, half};

Model load(const SmallGltf& gltf) {
    const TempFolder folder;
    return loadModel(folder.write("model.gltf", gltf.text()));
}

Scene loadAlone(const SmallGltf& gltf) {
    const TempFolder folder;
    return loadScene(folder.write("model.gltf", gltf.text()));
}

void expectNear(const glm::dvec3& found, const glm::dvec3& expected) {
    EXPECT_LT(glm::length(found - expected), tolerance) << found.x << ", " << found.y << ", " << found.z;
}

/// Adds a light with a node that has it.
json& addLight(SmallGltf& gltf, json light, json node) {
    json& lights = gltf.json["extensions"]["KHR_lights_punctual"]["lights"];
    node["extensions"]["KHR_lights_punctual"]["light"] = lights.size();
    lights.push_back(std::move(light));
    gltf.json["nodes"].push_back(std::move(node));
    return gltf.json["nodes"].back();
}

json& addCamera(SmallGltf& gltf, double fov, json node) {
    node["camera"] = gltf.json.value("cameras", json::array()).size();
    gltf.json["cameras"].push_back(
        {{"type", "perspective"}, {"perspective", {{"yfov", fov}, {"znear", 0.1}}}});
    gltf.json["nodes"].push_back(std::move(node));
    return gltf.json["nodes"].back();
}

TEST(GltfLightsTest, TheBrightestGivesSixWattsAndTheOthersTheirShare) {
    SmallGltf gltf = triangleGltf(); // its middle is at (0.5, 0.5, 0)
    gltf.json["extensionsRequired"] = {"KHR_lights_punctual"};
    addLight(gltf, {{"type", "directional"}, {"color", {1, 0.5, 0}}, {"intensity", 1000}, {"name", "a b"}},
             {{"rotation", down}});
    addLight(gltf, {{"type", "point"}, {"intensity", 2000}}, {{"translation", {0.5, 2.5, 0}}});
    addLight(gltf, {{"type", "spot"}, {"intensity", 1000}, {"spot", json::object()}},
             {{"translation", {0.5, 0.5, 1}}});
    const std::vector<Light> lights = load(gltf).lights;
    ASSERT_EQ(lights.size(), 3u);
    EXPECT_EQ(lights[0].name, "a b");
    EXPECT_EQ(lights[0].type, LightType::Directional);
    expectNear(lights[0].direction, {0, -1, 0});
    expectNear(lights[0].irradiance, {6, 3, 0});
    EXPECT_EQ(lights[1].type, LightType::Point);
    expectNear(lights[1].position, {0.5, 2.5, 0});
    expectNear(lights[1].intensity, glm::dvec3(12)); // 3 W/m² from 2 m
    EXPECT_EQ(lights[2].type, LightType::Point);
    expectNear(lights[2].intensity, glm::dvec3(6));
    EXPECT_FALSE(lights[1].isSpot());
}

TEST(GltfLightsTest, ASpotHasItsCone) {
    SmallGltf gltf = triangleGltf();
    const auto add = [&](json spot) {
        addLight(gltf, {{"type", "spot"}, {"spot", std::move(spot)}},
                 {{"translation", {0.5, 2, 0}}, {"rotation", down}});
    };
    add(json::object()); // the format's defaults
    add({{"innerConeAngle", 0.3}, {"outerConeAngle", 0.5}});
    add({{"innerConeAngle", 0.5}, {"outerConeAngle", 0.5}});
    add({{"outerConeAngle", 1.6}});
    const std::vector<Light> lights = load(gltf).lights;
    ASSERT_EQ(lights.size(), 2u) << "cones that the format does not allow give no light";
    EXPECT_TRUE(lights[0].isSpot());
    expectNear(lights[0].direction, {0, -1, 0});
    EXPECT_NEAR(lights[0].innerCone, 0, tolerance);
    EXPECT_NEAR(lights[0].outerCone, 45, tolerance);
    EXPECT_NEAR(lights[1].innerCone, glm::degrees(0.3), tolerance);
    EXPECT_NEAR(lights[1].outerCone, glm::degrees(0.5), tolerance);
}

TEST(GltfLightsTest, WhatGivesNoLightIsLeftOut) {
    SmallGltf gltf = triangleGltf();
    for (const json& light : {json{{"type", "directional"}, {"intensity", 0}},
                              json{{"type", "directional"}, {"color", {0, 0, 0}}},
                              json{{"type", "directional"}, {"color", {1, -1, 1}}}, json{{"type", "area"}}})
        addLight(gltf, light, json::object());
    addLight(gltf, {{"type", "directional"}}, {{"scale", {0, 0, 0}}});
    addLight(gltf, {{"type", "point"}}, {{"translation", {0.5, 0.5, 0}}});
    EXPECT_TRUE(load(gltf).lights.empty());
}

TEST(GltfLightsTest, AnIndexOutOfRangeIsAnError) {
    SmallGltf gltf = triangleGltf();
    addLight(gltf, {{"type", "point"}}, json::object())["extensions"]["KHR_lights_punctual"]["light"] = 1;
    const TempFolder folder;
    const auto file = folder.write("model.gltf", gltf.text());
    EXPECT_THAT(errorOf(folder, [&] { loadModel(file); }),
                HasSubstr("nodes[1].KHR_lights_punctual.light: expected an index below 1, found 1"));
}

TEST(GltfCamerasTest, LookAtThePointAbreastOfTheModel) {
    SmallGltf gltf = triangleGltf();
    addCamera(gltf, 1, {{"translation", {0, 3, 0}}, {"rotation", down}});
    addCamera(gltf, 1, {{"translation", {0, 0, -3}}});
    const std::vector<Camera> cameras = load(gltf).cameras;
    ASSERT_EQ(cameras.size(), 2u);
    expectNear(*cameras[0].position, {0, 3, 0});
    expectNear(*cameras[0].target, {0, 0.5, 0});
    expectNear(cameras[0].up, {0, 0, -1});
    EXPECT_NEAR(cameras[0].verticalFov, glm::degrees(1.0), tolerance);
    expectNear(*cameras[1].target, {0, 0, -4}); // the model is behind it
}

TEST(GltfCamerasTest, ThoseThatCannotSeeAreLeftOut) {
    SmallGltf gltf = triangleGltf();
    for (const double fov : {0.0, -1.0, 3.2})
        addCamera(gltf, fov, json::object());
    addCamera(gltf, 1, {{"scale", {0, 0, 0}}});
    gltf.json["cameras"].push_back(
        {{"type", "orthographic"}, {"orthographic", {{"xmag", 1}, {"ymag", 1}, {"znear", 0}, {"zfar", 1}}}});
    gltf.json["nodes"].push_back({{"camera", 4}});
    EXPECT_TRUE(load(gltf).cameras.empty());
}

TEST(GltfCamerasTest, AnIndexOutOfRangeIsAnError) {
    SmallGltf gltf = triangleGltf();
    gltf.json["nodes"][0]["camera"] = 0;
    const TempFolder folder;
    const auto file = folder.write("model.gltf", gltf.text());
    EXPECT_THAT(errorOf(folder, [&] { loadModel(file); }), HasSubstr("nodes[0].camera: expected no index"));
}

TEST(ModelAloneTest, HasASunUnlessALightOfItsOwnEntersTheWater) {
    SmallGltf gltf = triangleGltf(); // water at 1.6
    const json grazing = {-std::sin(0.05), 0, 0, std::cos(0.05)};
    addLight(gltf, {{"type", "directional"}, {"intensity", 5}}, {{"rotation", grazing}});
    addLight(gltf, {{"type", "point"}}, {{"translation", {0, 1.5, 0}}});
    EXPECT_EQ(loadAlone(gltf).lights.at(0).name, "sun");
    addLight(gltf, {{"type", "point"}, {"name", "lamp.1"}}, {{"translation", {0, 1.7, 0}}});
    addLight(gltf, {{"type", "point"}, {"name", "lamp.1"}}, {{"translation", {0, 1.8, 0}}});
    addLight(gltf, {{"type", "directional"}, {"name", "…"}, {"intensity", 5}}, {{"rotation", down}});
    const std::vector<Light> lights = loadAlone(gltf).lights;
    ASSERT_EQ(lights.size(), 3u);
    EXPECT_EQ(lights[0].name, "lamp_1");
    EXPECT_EQ(lights[0].type, LightType::Point);
    expectNear(lights[0].position, {0, 1.7, 0});
    EXPECT_EQ(lights[1].name, "light1");
    EXPECT_EQ(lights[2].name, "light2");
    expectNear(lights[2].irradiance, glm::dvec3(6));
}

TEST(ModelAloneTest, TakesASpotThatReachesDown) {
    SmallGltf gltf = triangleGltf();
    const json spot = {{"type", "spot"}, {"spot", {{"innerConeAngle", 0.1}, {"outerConeAngle", 0.4}}}};
    addLight(gltf, spot, {{"translation", {0, 2, 0}}, {"rotation", down}});
    addLight(gltf, spot, {{"translation", {0, 2, 0}}}); // looks along the surface
    const std::vector<Light> lights = loadAlone(gltf).lights;
    ASSERT_EQ(lights.size(), 2u);
    EXPECT_TRUE(lights[0].isSpot());
    EXPECT_NEAR(lights[0].outerCone, glm::degrees(0.4), tolerance);
    json& node = gltf.json["nodes"][1];
    node["rotation"] = {std::sin(0.3), 0, 0, std::cos(0.3)}; // and this one up
    gltf.json["nodes"][2]["rotation"] = node["rotation"];
    EXPECT_EQ(loadAlone(gltf).lights.at(0).name, "sun");
}

TEST(ModelAloneTest, TakesItsOwnCameraIfThatSeesTheModel) {
    struct Case {
        glm::dvec3 position;
        bool looksDown;
        bool taken;
    };
    const Case cases[] = {{{0.5, 5, 0}, true, true},       // above the water
                          {{0.5, 0.5, 3}, false, true},    // under it
                          {{0.5, 0.5, -3}, false, false},  // the model is behind it
                          {{9, 0.5, 3}, false, false},     // beside it
                          {{0.5, -0.2, 3}, false, false}}; // below the floor
    for (const Case& c : cases) {
        SmallGltf gltf = triangleGltf();
        json& node = addCamera(gltf, 0.8, {{"translation", {c.position.x, c.position.y, c.position.z}}});
        if (c.looksDown) node["rotation"] = down;
        const Camera camera = loadAlone(gltf).camera;
        EXPECT_EQ(camera.position.has_value(), c.taken) << c.position.x << " " << c.position.y;
        if (!c.taken) continue;
        expectNear(*camera.position, c.position);
        EXPECT_NEAR(camera.verticalFov, glm::degrees(0.8), tolerance);
    }
}

TEST(ModelAloneTest, TellsWhichLightsAndCamerasAreNotUsed) {
    SmallGltf gltf = triangleGltf();
    addLight(gltf, {{"type", "point"}, {"name", "Lamp"}}, {{"translation", {0, 50, 0}}});
    addCamera(gltf, 0.8, {{"translation", {0.5, 0.5, 3}}});
    EXPECT_TRUE(loadAlone(gltf).receivers[0].mesh->notices.empty());
    addLight(gltf, {{"type", "point"}, {"name", "Deep"}}, {{"translation", {0, 0.1, 0}}});
    addCamera(gltf, 0.8, {{"translation", {0.5, 0.5, 4}}});
    const auto notices = loadAlone(gltf).receivers[0].mesh->notices;
    ASSERT_EQ(notices.size(), 2u);
    EXPECT_TRUE(
        notices[0].ends_with("model.gltf: lights: not used: \"Deep\" (it does not get into the water)"));
    EXPECT_TRUE(notices[1].ends_with("cameras: not used: one without a name (the first one is used)"));
}

} // namespace
} // namespace limpid::io
