// Sheets that let part of the light through: closed forms of what they take and leave.
#include <gtest/gtest.h>

#include "reference/Traced.h"

namespace limpid {
namespace {

constexpr double paneSide = 3, floorSide = 1;

/// A pane half a metre over a floor, wider than that, under flat water and a sun straight above.
Scene under(Mesh pane, double y = -0.5) {
    Scene scene;
    scene.lights = {scenes::sunAt(0)};
    scene.receivers = {scenes::floorAt(-1, floorSide), scenes::shape("pane", std::move(pane), {0, y, 0})};
    scene.caustics.mapSize = 32;
    return scene;
}

Mesh pane(const Material& material) {
    Mesh mesh = makePlane({paneSide, paneSide}, glm::vec3(0.8f));
    mesh.materials[0] = material;
    return mesh;
}

Material blended(float alpha) {
    Material material;
    material.alphaMode = AlphaMode::Blend;
    material.baseColor = {0.2f, 0.5f, 0.9f, alpha};
    return material;
}

Material glass(float transmission) {
    Material material;
    material.baseColor = {0.9f, 0.5f, 0.2f, 1};
    material.transmission = transmission;
    return material;
}

/// Mean over a map, RGB, over what comes through the surface.
glm::dvec3 meanShare(const test::Traced& traced, std::size_t map) {
    glm::dvec3 sum(0);
    const auto& rgb = traced.map(map).irradiance;
    for (std::size_t i = 0; i < rgb.size(); ++i)
        sum[int(i % 3)] += double(rgb[i]);
    return sum / (double(rgb.size()) / 3) / test::transmittance(0, 1.333);
}

void expectNear(const glm::dvec3& found, const glm::dvec3& expected, const char* what) {
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(found[c], expected[c], 0.002 * std::max(expected[c], 0.1)) << what << ' ' << c;
}

void expectBalance(const test::Traced& traced) {
    EXPECT_LT(std::abs(traced.light().residual()), 1e-6 * traced.light().entering);
    EXPECT_GT(traced.light().entering, 0);
}

TEST(Transmittance, IsTheRuleOfThinSheets) {
    const glm::vec4 color(0.9f, 0.5f, 0.2f, 0.4f);
    Material material;
    EXPECT_EQ(transmittance(material, color, 0), glm::vec3(0));
    EXPECT_EQ(transmittance(material, color, 0.5f), 0.5f * glm::vec3(color)) << "alpha means nothing";
    material.alphaMode = AlphaMode::Mask;
    EXPECT_EQ(transmittance(material, color, 0.5f), glm::vec3(1)) << "a hole";
    material.alphaCutoff = 0.4f;
    EXPECT_EQ(transmittance(material, color, 0.5f), 0.5f * glm::vec3(color));
    material.alphaMode = AlphaMode::Blend;
    EXPECT_EQ(transmittance(material, color, 0), glm::vec3(1 - color.a));
    const glm::vec3 both = transmittance(material, color, 0.5f);
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(both[c], 0.6f + 0.4f * 0.5f * color[c], 1e-6f);
}

TEST(Sheets, ABlendedPaneTakesItsAlpha) {
    for (const float alpha : {0.3f, 0.5f, 0.7f}) {
        const test::Traced traced = test::trace(under(pane(blended(alpha))), 50'000);
        expectNear(meanShare(traced, 0), glm::dvec3(1 - alpha), "floor");
        expectNear(meanShare(traced, 1), glm::dvec3(alpha), "pane");
        expectBalance(traced);
    }
}

TEST(Sheets, AlphaComesFromTextureAndVertexColourToo) {
    Mesh mesh = pane(blended(0.8f));
    mesh.images = {{2, 1, {255, 255, 255, 255, 255, 255, 255, 51}, true}};
    mesh.materials[0].baseColorImage = 0;
    mesh.materials[0].baseColorNearest = true;
    mesh.colors.assign(mesh.positions.size(), glm::vec4(1, 1, 1, 0.5f));
    const test::Traced traced = test::trace(under(std::move(mesh)), 200'000);
    // Half of it has alpha 0.8 * 0.5, half a fifth of that.
    expectNear(meanShare(traced, 0), glm::dvec3(1 - 0.5 * (0.4 + 0.08)), "floor");
    expectBalance(traced);
}

TEST(Sheets, ATransmissivePaneColoursTheLight) {
    const glm::dvec3 through = 0.7 * glm::dvec3(0.9, 0.5, 0.2);
    const test::Traced traced = test::trace(under(pane(glass(0.7f))), 50'000);
    expectNear(meanShare(traced, 0), through, "floor");
    expectNear(meanShare(traced, 1), 1.0 - through, "pane");
    expectBalance(traced);
}

TEST(Sheets, ATransmissionTextureCountsItsRed) {
    Mesh mesh = pane(glass(0.7f));
    mesh.images = {{1, 1, {102, 255, 255, 255}, false}};
    mesh.materials[0].transmissionImage = 0;
    const test::Traced traced = test::trace(under(std::move(mesh)), 50'000);
    expectNear(meanShare(traced, 0), 0.7 * 0.4 * glm::dvec3(0.9, 0.5, 0.2), "floor");
}

TEST(Sheets, AClosedBodyIsItsTwoFaces) {
    Mesh slab = makeBox({paneSide, 0.1, paneSide}, glm::vec3(0.8f));
    slab.materials[0] = glass(0.7f);
    const glm::dvec3 once = 0.7 * glm::dvec3(0.9, 0.5, 0.2);
    const test::Traced traced = test::trace(under(std::move(slab)), 50'000);
    expectNear(meanShare(traced, 0), once * once, "floor");
    expectBalance(traced);
}

TEST(Sheets, ClearGlassIsAsNone) {
    Material clear = glass(1);
    clear.baseColor = glm::vec4(1);
    const test::Traced traced = test::trace(under(pane(clear)), 50'000);
    expectNear(meanShare(traced, 0), glm::dvec3(1), "floor");
    EXPECT_FALSE(traced.covered(1, 16, 16)) << "what takes nothing has no texels";
}

TEST(Sheets, AFloorHasItsTexelsUnderASheetOfItsOwnMesh) {
    for (const Material& material : {blended(0.6f), glass(0.7f)}) {
        Mesh both = makePlane({floorSide, floorSide}, glm::vec3(0.8f));
        scenes::join(both, pane(material), {0, 0.5, 0});
        Scene scene = under(pane(material));
        scene.receivers = {scenes::shape("pool", std::move(both), {0, -1, 0})};
        const test::Traced traced = test::trace(scene, 50'000);
        ASSERT_TRUE(traced.covered(0, 16, 16));
        const std::size_t middle = 3 * (16 * 32 + 16);
        const glm::vec3 through = transmittance(material, material.baseColor, material.transmission);
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_NEAR(double(traced.map(0).irradiance[middle + c]) / test::transmittance(0, 1.333),
                        double(through[int(c)]), 5e-3);
        expectBalance(traced);
    }
}

TEST(Sheets, APaneAboveTheWaterKeepsLightFromIt) {
    const glm::dvec3 through = 0.7 * glm::dvec3(0.9, 0.5, 0.2);
    const test::Traced traced = test::trace(under(pane(glass(0.7f)), 0.5), 50'000);
    expectNear(meanShare(traced, 0), through, "floor");
    expectBalance(traced);
    const double open = traced.job.patchSize.x * traced.job.patchSize.y - paneSide * paneSide;
    const double share = (through.x + through.y + through.z) / 3;
    const double expected = (paneSide * paneSide * share + open) * test::transmittance(0, 1.333);
    EXPECT_NEAR(traced.light().entering, expected, 0.002 * expected);
}

TEST(Sheets, TheBalanceHoldsUnderWavesInWaterThatTakesLight) {
    Mesh ball = makeSphere(0.3, glm::vec3(0.8f));
    ball.materials[0] = glass(0.6f);
    Scene scene = under(pane(blended(0.5f)));
    scene.receivers.push_back(scenes::shape("ball", std::move(ball), {0.1, -0.65, 0}));
    scene.receivers[1].scale = glm::dvec3(0.2);
    scene.water.waves = {scenes::cosine(0.01, 0.5, {1, 0.3})};
    scene.water.absorption = {0.3, 0.1, 0.05};
    scene.water.scattering = {0.02, 0.03, 0.04};
    const test::Traced traced = test::trace(scene, 100'000);
    expectBalance(traced);
    const reference::TracedLight& light = traced.light();
    EXPECT_GT(light.absorbed, 0.02 * light.entering);
    EXPECT_GT(light.missed, 0) << "beside the floor, also through the pane";
}

} // namespace
} // namespace limpid
