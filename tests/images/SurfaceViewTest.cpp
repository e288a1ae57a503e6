// What the surface shows: mirrored in it, and through it from below.
#include <cmath>

#include "core/Optics.h"
#include "images/PictureFixture.h"

namespace limpid {
namespace {

constexpr double ior = 1.333;

/// Nothing but ambient light in and over flat water.
Scene unlit() {
    Scene scene;
    scene.ambientRadiance = {0.5, 0.4, 0.3};
    scene.skyRadiance = {0.02, 0.04, 0.08};
    scene.water.grid = {16, 16};
    return scene;
}

class SurfaceViewTest : public PictureFixture {
  protected:
    static void expectNear(const glm::dvec3& found, const glm::dvec3& expected, const char* what) {
        // Single precision all the way; Fresnel at a pixel's middle stands for its four samples.
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(found[c] / expected[c], 1, 0.005) << what << ", channel " << c;
    }
};

/// A post in front of the camera, its front at z = 0.
Scene postInDarkWater() {
    Scene scene = unlit();
    scene.water.absorption = glm::dvec3(1e4); // nothing comes up
    scene.receivers = {scenes::shape("post", makeBox({0.4, 2, 0.4}, glm::vec3(0.8f)), {0, -0.5, -0.2})};
    scene.camera.position = {0, 0.8, 3};
    scene.camera.target = {0, -0.1, 0};
    return scene;
}

TEST_F(SurfaceViewTest, flatWaterMirrorsAPostWithFresnelsShare) {
    const Scene scene = postInDarkWater();
    const glm::ivec2 size(160, 120);
    const Picture picture = render(scene, size);
    for (const double height : {0.05, 0.2, 0.45}) {
        const glm::ivec2 pixel(pixelOf(scene.camera, {0.05, -height, 0}, size));
        const glm::dvec3 view = rayThrough(scene.camera, pixel, size);
        const double mirrors = 1 - optics::fresnelTransmittance(-view.y, 1 / ior);
        expectNear(at(picture, pixel.x, pixel.y), mirrors * 0.8 * scene.ambientRadiance, "post");
    }
}

TEST_F(SurfaceViewTest, aMirrorImageEndsWhereItsObjectEnds) {
    const Scene scene = postInDarkWater();
    const glm::ivec2 size(160, 120);
    const Picture picture = render(scene, size);
    // The post's mirrored top edge, and its right one; two pixels to either side, past anti-aliasing.
    const glm::dvec2 top = pixelOf(scene.camera, {0, -0.5, 0}, size);
    const glm::dvec2 right = pixelOf(scene.camera, {0.2, -0.2, 0}, size);
    const auto isPost = [&](const glm::dvec2& pixel) {
        const glm::dvec3 seen = at(picture, int(pixel.x), int(pixel.y));
        return seen.x > seen.z; // its ambient light is red, the sky blue
    };
    EXPECT_TRUE(isPost(top - glm::dvec2(0, 2)));
    EXPECT_FALSE(isPost(top + glm::dvec2(0, 2)));
    EXPECT_TRUE(isPost(right - glm::dvec2(2, 0)));
    EXPECT_FALSE(isPost(right + glm::dvec2(2, 0)));
}

TEST_F(SurfaceViewTest, wavesShakeAMirrorImageAndKeepItsLight) {
    Scene scene = postInDarkWater();
    scene.skyRadiance = glm::dvec3(0);
    const glm::ivec2 size(160, 120);
    const auto below = [&](const Picture& picture) {
        double sum = 0;
        for (int y = int(pixelOf(scene.camera, {0, 0, 0}, size).y) + 2; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x)
                sum += at(picture, x, y).x;
        return sum;
    };
    const Picture flat = render(scene, size);
    scene.water.waves = {scenes::cosine(0.001, 0.12, {0.3, 1})};
    scene.water.center = {0, 0.5};
    scene.water.size = {2, 4};
    scene.water.grid = {100, 200};
    const Picture waves = render(scene, size);
    int changed = 0;
    for (std::size_t i = 0; i < flat.rgb.size(); i += 3)
        changed += std::abs(flat.rgb[i] - waves.rgb[i]) > 0.002f;
    EXPECT_GT(changed, 200);
    // Slopes of 0.052 turn a mirrored ray by 0.1 at most, to either side alike: of the image's width of 0.13
    // and height of 0.16 (as angles), what is lost to second order is 0.1² / 2 / 0.13, 4 %.
    EXPECT_NEAR(below(waves) / below(flat), 1, 0.04);
}

TEST_F(SurfaceViewTest, fromBelowTheSurfaceMirrorsTheFloor) {
    Scene scene = unlit();
    scene.water.absorption = {0.3, 0.2, 0.1};
    scene.water.scattering = {0.05, 0.05, 0.05};
    scene.receivers = {scenes::floorAt(-1, 12)};
    scene.camera.position = {0, -0.5, 0};
    scene.camera.target = {2, 0.2, 0}; // 19° up; Snell's window begins at 41°
    const glm::ivec2 size(64, 48);
    const Picture picture = render(scene, size);
    const glm::dvec3 view = glm::normalize(*scene.camera.target - *scene.camera.position);
    const double metres = 1.5 / view.y; // to the mirrored floor at +1
    const glm::dvec3 lost = scene.water.absorption + scene.water.scattering;
    const glm::dvec3 left = optics::extinction(lost, metres);
    const glm::dvec3 deep = scene.ambientRadiance * scene.water.scattering / lost;
    const glm::dvec3 expected = 0.8 * scene.ambientRadiance * left + deep * (1.0 - left);
    // The middle of the picture lies between four pixels; the path's length is nearly linear over them.
    const glm::dvec3 found =
        0.25 * (at(picture, 31, 23) + at(picture, 32, 23) + at(picture, 31, 24) + at(picture, 32, 24));
    expectNear(found, expected, "floor");
}

TEST_F(SurfaceViewTest, snellsWindowShowsWhatStandsOutOfTheWater) {
    Scene scene = unlit();
    scene.water.absorption = {0.3, 0.2, 0.1};
    // Seen at 60° from vertical in air, at 40.5° in water, where the two meet at x = -1 tan 60°.
    const double inAir = glm::radians(60.0), inWater = std::asin(std::sin(inAir) / ior);
    const double height = 1, depth = 0.5;
    const double across = height * std::tan(inAir) + depth * std::tan(inWater);
    scene.receivers = {scenes::shape("sign", makeBox({0.2, 0.2, 0.2}, glm::vec3(0.8f)), {across, height, 0})};
    scene.camera.position = {0, -depth, 0};
    scene.camera.target = {depth * std::tan(inWater), 0, 0};
    scene.camera.verticalFov = 20;
    const Picture picture = render(scene, {65, 49});
    const glm::dvec3 left = optics::extinction(scene.water.absorption, depth / std::cos(inWater));
    const double through = optics::fresnelTransmittance(std::cos(inWater), ior);
    expectNear(at(picture, 32, 24), through * ior * ior * 0.8 * scene.ambientRadiance * left, "sign");
    EXPECT_GT(at(picture, 60, 24).z, at(picture, 60, 24).x) << "sky beside it";
}

/// The camera looks along the surface; each pixel below the horizon has a closed form, however near the eye
/// is.
TEST_F(SurfaceViewTest, aCameraAtTheLevelSeesTheFloorBelowTheHorizon) {
    Scene scene = unlit();
    scene.water.absorption = {0.3, 0.2, 0.1};
    scene.receivers = {scenes::floorAt(-1, 3)};
    for (const double height : {0.0, 1e-7, 1e-3, 0.02}) {
        SCOPED_TRACE(height);
        scene.camera.position = {0, height, 0};
        scene.camera.target = {0, height, -1};
        const glm::ivec2 size(32, 24);
        const Picture picture = render(scene, size);
        expectNear(at(picture, 16, 8), scene.skyRadiance, "sky");
        for (const int row : {14, 18, 23}) {
            const glm::dvec3 view = rayThrough(scene.camera, {16, row}, size);
            const double through = optics::fresnelTransmittance(-view.y, 1 / ior);
            const double down = std::sqrt(1 - (1 - view.y * view.y) / (ior * ior));
            const glm::dvec3 left = optics::extinction(scene.water.absorption, 1 / down);
            const glm::dvec3 expected = through * 0.8 * scene.ambientRadiance * left / (ior * ior) +
                                        (1 - through) * scene.skyRadiance;
            // A pixel spans 1.9°; near the horizon, Fresnel's law bends by 0.02 over a sample, of 0.4.
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(at(picture, 16, row)[c] / expected[c], 1, 0.02) << "row " << row;
        }
    }
}

TEST_F(SurfaceViewTest, wavesDecideWhetherTheCameraIsUnderWater) {
    Scene scene = unlit();
    scene.receivers = {scenes::floorAt(-1, 4)};
    scene.water.waves = {scenes::cosine(0.02, 1, {1, 0})}; // crest at x = 0, trough at 0.5
    scene.water.grid = {128, 128};
    scene.camera.verticalFov = 30;
    const auto seesSky = [&](double x, double y) {
        // Up, but less steeply than Snell's window begins: under water the surface mirrors the floor.
        scene.camera.position = {x, y, 0};
        scene.camera.target = {x, y + 0.3, -1};
        const glm::dvec3 seen = at(render(scene, {16, 12}), 8, 6);
        return glm::length(seen - scene.skyRadiance) < 1e-6;
    };
    EXPECT_TRUE(seesSky(0.5, -0.01));
    EXPECT_FALSE(seesSky(0.5, -0.025));
    EXPECT_FALSE(seesSky(0, 0.01));
    EXPECT_TRUE(seesSky(0, 0.025));
}

} // namespace
} // namespace limpid
