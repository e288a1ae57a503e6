#include <cmath>

#include "Folders.h"
#include "core/Optics.h"
#include "images/PictureFixture.h"
#include "io/images/Images.h"
#include "io/toml/SceneFile.h"
#include "view/ToneMapped.h"

namespace limpid {
namespace {

constexpr double pi = 3.14159265358979;

class PictureTest : public PictureFixture {};

TEST_F(PictureTest, aFloorUnderFlatWaterHasItsRadiance) {
    Scene scene = floorFromAbove();
    scene.water.absorption = {0.3, 0.1, 0.05};
    scene.water.scattering = {0.02, 0.02, 0.02};
    // Not overhead, where its mirror image would be in the picture.
    scene.lights[0].direction = scenes::sunAt(40).direction;
    const Picture picture = render(scene, {64, 48});
    // Down through the surface, once through the water, reflected, up again, out with L/n² and Fresnel's
    // share.
    const double through = optics::fresnelTransmittance(1.0, 1 / 1.333);
    const glm::dvec3 lost = scene.water.absorption + scene.water.scattering;
    const glm::dvec3 left = optics::extinction(lost, 1.0);
    const double cosine = std::cos(glm::radians(40.0));
    const double refracted = std::cos(std::asin(std::sin(glm::radians(40.0)) / 1.333));
    const glm::dvec3 irradiance = scene.lights[0].irradiance * cosine *
                                  optics::fresnelTransmittance(cosine, 1 / 1.333) *
                                  optics::extinction(lost, 1 / refracted);
    const glm::dvec3 floor = 0.8 / pi * irradiance + 0.8 * scene.ambientRadiance;
    const glm::dvec3 deep = scene.ambientRadiance * scene.water.scattering / lost;
    const glm::dvec3 below = floor * left + deep * (1.0 - left);
    const glm::dvec3 expected = through * below / (1.333 * 1.333) + (1 - through) * scene.skyRadiance;
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(at(picture, 32, 24)[c] / expected[c], 1, 0.005) << "channel " << c;
}

TEST_F(PictureTest, aSymmetricSceneGivesASymmetricPicture) {
    Scene scene = floorFromAbove();
    scene.water.waves = {scenes::cosine(0.01, 0.5, {0, 1})};
    scene.camera.position = {0, 1.5, 2};
    const Picture picture = render(scene, {64, 48});
    double difference = 0, sum = 0;
    for (int y = 0; y < 48; ++y)
        for (int x = 0; x < 32; ++x) {
            difference += glm::length(at(picture, x, y) - at(picture, 63 - x, y));
            sum += glm::length(at(picture, x, y));
        }
    // The diagonals of the water's quads are not mirrored.
    EXPECT_LT(difference / sum, 0.02);
}

TEST_F(PictureTest, waterLiftsWhatLiesInIt) {
    Scene scene = floorFromAbove();
    scene.receivers = {scenes::shape("ball", makeSphere(0.1, glm::vec3(1)), {0, -1, 0})};
    scene.ambientRadiance = glm::dvec3(1);
    scene.skyRadiance = glm::dvec3(0);
    scene.camera.position = {0, 1, 2};
    // The camera looks at where the flat surface shows the ball; it must be in the middle of the picture.
    const double x = optics::flatCrossing(1.0, 1.0, 2.0, 1.333);
    scene.camera.target = glm::dvec3(0, 0, 2 - x);
    scene.camera.verticalFov = 30;
    scene.water.scattering = glm::dvec3(0.0);
    scene.water.absorption = glm::dvec3(1e-6); // endless water is dark
    const Picture picture = render(scene, {80, 60});
    glm::dvec3 center(0);
    for (int row = 0; row < 60; ++row)
        for (int column = 0; column < 80; ++column)
            center += at(picture, column, row).x * glm::dvec3(column + 0.5, row + 0.5, 1);
    ASSERT_GT(center.z, 0);
    EXPECT_NEAR(center.x / center.z, 40, 0.5);
    EXPECT_NEAR(center.y / center.z, 30, 1.0);
}

TEST_F(PictureTest, theSunGlittersWhereItsMirrorImageIs) {
    Scene scene = floorFromAbove();
    scene.receivers = {scenes::floorAt(-50, 0.1)};
    scene.ambientRadiance = scene.skyRadiance = glm::dvec3(0);
    scene.water.center = {0, 0};
    scene.water.size = {8, 8};
    scene.lights[0].direction = scenes::sunAt(30).direction;
    scene.camera.position = {0, 2, 0};
    scene.camera.verticalFov = 90;
    const Picture picture = render(scene, {96, 64});
    glm::dvec3 center(0);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 96; ++x)
            center += at(picture, x, y).x * glm::dvec3(x + 0.5, y + 0.5, 1);
    ASSERT_GT(center.z, 0);
    // The sun travels towards +x, so its image lies at -x under 30°: tan 30° of half the picture's height.
    EXPECT_NEAR(center.x / center.z, 48 - 32 * std::tan(pi / 6), 1.0);
    EXPECT_NEAR(center.y / center.z, 32, 0.5);
}

TEST_F(PictureTest, anUnlitSceneShowsAmbientAlone) {
    Scene scene = floorFromAbove();
    scene.lights.clear();
    const Picture picture = render(scene, {16, 12});
    const double through = optics::fresnelTransmittance(1.0, 1 / 1.333);
    const double expected = through * 0.8 * 0.05 / (1.333 * 1.333) + (1 - through) * 0.3;
    EXPECT_NEAR(at(picture, 8, 6).x / expected, 1, 0.005);
}

TEST_F(PictureTest, aSheetAHairOverTheFloorHidesIt) {
    // The default scene's floor lies 1e-4 of a model's extent under it.
    Scene scene = floorFromAbove();
    scene.receivers = {
        scenes::shape("floor", makePlane(glm::dvec2(6), glm::vec3(0, 0, 0.8f)), {0, -1, 0}),
        scenes::shape("sheet", makePlane(glm::dvec2(4), glm::vec3(0.8f, 0, 0)), {0, -1 + 1e-4, 0})};
    scene.water.level = -4;
    scene.skyRadiance = glm::dvec3(0);
    scene.camera.position = {0, 1, 3};
    scene.camera.target = {0, -1, 0};
    scene.camera.verticalFov = 20;
    const Picture picture = render(scene, {64, 48});
    for (std::size_t i = 0; i < picture.rgb.size(); i += 3)
        EXPECT_EQ(picture.rgb[i + 2], 0) << "pixel " << i / 3;
}

TEST_F(PictureTest, twoHalfLightsLookLikeOne) {
    Scene scene = floorFromAbove();
    scene.receivers.push_back(scenes::model("fish", -1));
    const Picture one = render(scene, {64, 48});
    scene.lights = {scenes::sunAt(0, "a"), scenes::sunAt(0, "b")};
    for (Light& light : scene.lights)
        light.irradiance = {1.5, 1, 0.5};
    const Picture two = render(scene, {64, 48});
    // Light is added in a half-float target, where a sum rounds differently: one part in 1,024.
    for (std::size_t i = 0; i < one.rgb.size(); ++i)
        EXPECT_NEAR(one.rgb[i], two.rgb[i], 2e-3f * one.rgb[i] + 1e-5f);
}

TEST_F(PictureTest, skippingChangesNoPixel) {
    Scene scene = floorFromAbove();
    scene.receivers.push_back(scenes::model("fish", -1));
    scene.water.waves = {scenes::noise(0.01, 0.4)};
    Engine engine(context());
    engine.set(scene);
    const Picture skipping = engine.render(0, {64, 48});
    engine.setSkipping(false);
    EXPECT_EQ(skipping.rgb, engine.render(0, {64, 48}).rgb);
}

/// The default scene against a picture that was looked at. Rasterisers may place an edge one sample apart, so
/// the share of pixels that are visibly off is bounded, not each pixel.
TEST_F(PictureTest, theDefaultSceneLooksAsItDid) {
    const std::filesystem::path root = test::rootFolder();
    Scene scene = io::loadScene(root / "profiles/scenes/teapot.toml",
                                {{"caustics.map_size", "256"}, {"water.grid", "[96, 96]"}});
    const Picture picture = render(scene, {240, 135});
    const auto shown = toneMapped(picture, scene.camera.exposure);
    const auto mine = std::filesystem::path(test::buildFolder()) / "picture-test-teapot.png";
    io::writePng(mine, picture.size.x, picture.size.y, shown);
    const io::FloatImage golden = io::readImage(root / "tests/images/golden/teapot.png");
    ASSERT_EQ(golden.width, picture.size.x);
    ASSERT_EQ(golden.height, picture.size.y);
    int off = 0;
    for (std::size_t i = 0; i < shown.size(); i += 3) {
        float largest = 0;
        for (std::size_t c = 0; c < 3; ++c)
            largest = std::max(largest, std::abs(float(shown[i + c]) - 255 * golden.data[i + c]));
        off += largest > 6;
    }
    EXPECT_LT(off, 0.005 * double(shown.size() / 3))
        << "compare " << mine << " with tests/images/golden/teapot.png";
}

} // namespace
} // namespace limpid
