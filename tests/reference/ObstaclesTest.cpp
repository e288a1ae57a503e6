// What stands in the light's way: over the water, in it, and the water itself.
#include <numbers>

#include <gtest/gtest.h>

#include "reference/Traced.h"

namespace limpid {
namespace {

Receiver boxAt(const char* name, const glm::dvec3& size, const glm::dvec3& at) {
    return scenes::shape(name, makeBox(size, glm::vec3(0.8f)), at);
}

TEST(Emergent, aPostShadesTheSurface) {
    Scene scene;
    scene.lights = {scenes::sunAt(45)};
    scene.receivers = {scenes::floorAt(-1, 3), boxAt("post", {0.2, 1, 0.2}, {0, 0, 0})};
    scene.caustics.mapSize = 64;
    const test::Traced traced = test::trace(scene, 400'000);
    const double perArea = std::cos(glm::radians(45.0)) * test::transmittance(glm::radians(45.0), 1.333);
    const double whole = traced.job.patchSize.x * traced.job.patchSize.y;
    // Its own section, and half a metre of it laid down by 45°.
    const double shaded = 0.2 * 0.2 + 0.2 * 0.5;
    EXPECT_NEAR(whole - traced.light().entering / perArea, shaded, 0.005 * shaded);
    EXPECT_LT(std::abs(traced.light().residual()), 1e-6 * traced.light().entering);
}

TEST(Emergent, crestsShadeTroughs) {
    // Without bending and reflection what gets in is what falls on the surface, and a low sun sends as much
    // onto waves as onto the level, no matter where: here from crest to crest.
    for (const double elevation : {1.0, 4.0, 10.0}) {
        Scene scene;
        scene.lights = {scenes::sunAt(90 - elevation)};
        scene.receivers = {scenes::floorAt(-1)};
        scene.water.ior = 1;
        scene.water.waves = {scenes::cosine(0.004, 0.2, {1, 0})};
        scene.water.center = glm::dvec2(0);
        scene.water.size = glm::dvec2(2, 0.2);
        scene.caustics.mapSize = 16;
        const test::Traced traced = test::trace(scene, 200'000);
        const double expected = 0.4 * std::sin(glm::radians(elevation));
        EXPECT_NEAR(traced.light().entering, expected, 0.002 * expected) << elevation;
    }
}

TEST(Thin, aWireGetsItsShareFromCellsManyTimesAsWide) {
    Scene scene;
    scene.lights = {scenes::sunAt(0)};
    scene.receivers = {scenes::floorAt(-1), boxAt("wire", {0.002, 0.002, 1.8}, {0.1, -0.5, 0})};
    scene.caustics.mapSize = 256;
    double taken = 0, floor = 0;
    constexpr int seeds = 4;
    for (int seed = 1; seed <= seeds; ++seed) {
        const test::Traced traced = test::trace(scene, 500'000, std::uint64_t(seed));
        taken += (traced.map(1).deposited + traced.light().rejected) / seeds;
        floor += traced.map(0).deposited / seeds;
    }
    const double light = test::transmittance(0, 1.333), expected = light * 0.002 * 1.8;
    // Four cells in a row are 36 mm here: 50 of these groups lie along the wire in each of 32 batches, and
    // one in 18 meets it with its ray at random, 89 in all: one tenth of deviation. Counting only what
    // corners meet would give half.
    EXPECT_NEAR(taken, expected, 0.3 * expected);
    EXPECT_NEAR(floor + taken, 4 * light, 0.001 * 4 * light);
}

TEST(Thin, aCutOutLetsLightThrough) {
    Mesh sheet = makePlane({1, 1}, glm::vec3(0.8f));
    Image image{2, 2, std::vector<std::uint8_t>(16, 255), true};
    image.rgba[3] = image.rgba[15] = 0; // two of four texels are holes
    sheet.images = {image};
    sheet.materials[0].baseColorImage = 0;
    sheet.materials[0].baseColorNearest = true;
    sheet.materials[0].alphaMode = AlphaMode::Mask;
    for (glm::vec2& uv : sheet.uvs)
        uv *= 4.0f;
    Scene scene;
    scene.lights = {scenes::sunAt(0)};
    scene.receivers = {scenes::floorAt(-1), scenes::shape("sheet", std::move(sheet), {0, -0.5, 0})};
    scene.caustics.mapSize = 128;
    const test::Traced traced = test::trace(scene, 400'000);
    const double light = test::transmittance(0, 1.333);
    EXPECT_NEAR(traced.map(1).deposited, 0.5 * light, 0.01 * light);
    EXPECT_NEAR(traced.map(0).deposited, 3.5 * light, 0.01 * light);
    int covered = 0;
    for (int y = 0; y < 128; ++y)
        for (int x = 0; x < 128; ++x)
            covered += traced.covered(1, x, y);
    EXPECT_EQ(covered, 128 * 128 / 2) << "the map has the holes too";
}

TEST(Disc, anEdgeHasAHalfShadow) {
    // A sheet over one half, a metre above the floor. Seen from the floor the sun's disc is smaller by the
    // index of refraction, and the sheet's edge cuts a segment from it.
    Scene scene;
    scene.lights = {scenes::sunAt(0)};
    scene.lights[0].angularDiameter = 8;
    scene.receivers = {scenes::floorAt(-1.2, 0.5),
                       scenes::shape("sheet", makePlane({2, 2}, glm::vec3(0.8f)), {-1, -0.2, 0})};
    scene.caustics.mapSize = 64;
    const test::Traced traced = test::trace(scene, 3'000'000);
    const double radius = std::tan(test::refractedAngle(glm::radians(4.0), 1.333));
    double error = 0;
    for (int y = 8; y < 56; ++y)
        for (int x = 0; x < 64; ++x) {
            const double u = glm::clamp(traced.position(0, x, y).x / radius, -1.0, 1.0);
            const double share = 0.5 + (u * std::sqrt(1 - u * u) + std::asin(u)) / std::numbers::pi;
            error += std::abs(traced.irradiance(0, x, y) / test::transmittance(0, 1.333) - share) / (48 * 64);
        }
    printf("half shadow: mean error %.4f of full light, standard error %.4f\n", error,
           traced.map(0).standardError);
    // 512 directions; a texel of 8 mm is a thirteenth of the shadow's width.
    EXPECT_LT(error, 0.003);
}

} // namespace
} // namespace limpid
