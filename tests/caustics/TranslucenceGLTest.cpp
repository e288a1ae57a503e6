// Light through sheets: what goes on behind them and what they take, by closed forms, in every method.
#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "engine/EngineFixture.h"

namespace limpid {
namespace {

/// Of light straight down, the share that enters flat water.
const double entering = 1 - std::pow(0.333 / 2.333, 2);

class TranslucenceGLTest : public EngineGLTest, public ::testing::WithParamInterface<Method> {
  protected:
    /// A pane of 1 m half-way down over a floor of 2 m, light straight down.
    static Scene under(const Material& material, Method method, Image image = {}) {
        Mesh pane = makePlane(glm::dvec2(1), glm::vec3(0.8f));
        pane.materials[0] = material;
        if (image.width > 0) pane.images.push_back(std::move(image));
        Scene scene;
        scene.water.level = 1;
        scene.water.grid = {128, 128};
        scene.lights = {scenes::sunAt(0)};
        scene.receivers = {scenes::floorAt(0), scenes::shape("pane", std::move(pane), {0, 0.5, 0})};
        scene.caustics.mapSize = 128;
        scene.caustics.method = method;
        return scene;
    }
    static glm::dvec3 middle(const MapData& map) {
        const std::size_t i =
            std::size_t(map.size.y / 2) * std::size_t(map.size.x) + std::size_t(map.size.x / 2);
        return {map.irradiance[3 * i], map.irradiance[3 * i + 1], map.irradiance[3 * i + 2]};
    }
    static void expectNear(const glm::dvec3& found, const glm::dvec3& expected, double relative) {
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(found[c], expected[c], relative * std::max(expected[c], 0.01)) << "channel " << c;
    }
};

TEST_P(TranslucenceGLTest, whatIsBlendedLetsOneLessAlphaThrough) {
    for (const float alpha : {0.3f, 0.5f, 0.7f}) {
        Material material;
        material.alphaMode = AlphaMode::Blend;
        material.baseColor = {0.2f, 0.5f, 1, alpha};
        const Baked baked = bake(under(material, GetParam()));
        SCOPED_TRACE(fmt::format("alpha {}", alpha));
        expectNear(middle(baked.maps.at(0)), glm::dvec3(entering * double(1 - alpha)), 5e-3);
        expectNear(middle(baked.maps.at(1)), glm::dvec3(entering * double(alpha)), 5e-3);
    }
}

TEST_P(TranslucenceGLTest, aTransmissiveSheetTakesItsColourOut) {
    Material material;
    material.transmission = 0.7f;
    material.baseColor = {0.2f, 0.6f, 0.9f, 1};
    const Baked baked = bake(under(material, GetParam()));
    const glm::dvec3 through = 0.7 * glm::dvec3(0.2, 0.6, 0.9);
    expectNear(middle(baked.maps.at(0)), entering * through, 5e-3);
    expectNear(middle(baked.maps.at(1)), entering * (1.0 - through), 5e-3);
}

TEST_P(TranslucenceGLTest, aFloorHasItsTexelsUnderASheetOfItsOwnMesh) {
    Material blend, glass;
    blend.alphaMode = AlphaMode::Blend;
    blend.baseColor = {0.2f, 0.5f, 1, 0.6f};
    glass.transmission = 0.7f;
    glass.baseColor = {0.2f, 0.6f, 0.9f, 1};
    for (const Material& material : {blend, glass}) {
        Scene scene = under(material, GetParam());
        Mesh floor = *scene.receivers[0].mesh;
        scenes::join(floor, *scene.receivers[1].mesh, {0, 0.5, 0});
        scene.receivers = {scenes::shape("pool", std::move(floor), glm::dvec3(0))};
        const glm::dvec3 through(transmittance(material, material.baseColor, material.transmission));
        expectNear(middle(bake(scene).maps.at(0)), entering * through, 5e-3);
    }
}

INSTANTIATE_TEST_SUITE_P(methods, TranslucenceGLTest, ::testing::ValuesIn(allMethods()),
                         [](const auto& method) {
                             std::string name(methodName(method.param));
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

TEST_F(TranslucenceGLTest, aNetLetsItsHolesThrough) {
    // 32 x 32 meshes, three quarters of each open: finer than a texel of the floor.
    Image image{64, 64, std::vector<std::uint8_t>(64 * 64 * 4, 255)};
    for (std::size_t i = 0; i < 64 * 64; ++i)
        if (i % 2 == 1 || i / 64 % 2 == 1) image.rgba[4 * i + 3] = 0;
    Material material;
    material.alphaMode = AlphaMode::Mask;
    material.baseColorImage = 0;
    material.baseColorNearest = true;
    for (const int size : {32, 256}) {
        Scene scene = under(material, Method::ExactBeam, image);
        scene.caustics.mapSize = size;
        EXPECT_NEAR(bake(scene).maps.at(0).deposited / (entering * (3 + 0.75)), 1, 1e-3) << "map " << size;
    }
}

} // namespace
} // namespace limpid
