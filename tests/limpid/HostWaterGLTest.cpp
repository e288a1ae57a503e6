// Water in a texture of the host's: the surface and the maps that the same heights give from elsewhere, and
// what moves with the texture alone.
#include <cmath>

#include <gmock/gmock.h>

#include "engine/Scenes.h"
#include "limpid/Caustics.h"
#include "limpid/HostChecks.h"
#include "limpid/HostData.h"
#include "plan/WaveTerms.h"
#include "water/WaterSurface.h"

namespace limpid {
namespace {

using namespace test;

constexpr double tau = 6.283185307179586;
double ripple(double x, double z) {
    return 0.01 * std::sin(tau * (x / 0.8 + z / 1.1));
}

Scene sceneOf(const std::vector<Wave>& waves) {
    Scene scene = scenes::floorPastSphere(30);
    scene.water.waves = waves;
    scene.water.center = glm::dvec2(0);
    scene.water.size = glm::dvec2(2.4);
    scene.caustics.mapSize = 64;
    return scene;
}

TEST(HostWaterGLTest, theSurfaceGoesThroughItsHeights) {
    gl::Context context;
    const HostTexture texture;
    texture.fill(ripple);
    Water water;
    water.waves = {waveOf(texture.water())};
    WaterSurface surface(context);
    const WaterPatch patch{{0.3, -0.1}, {3, 2}, {61, 47}};
    surface.update(water, patch, {}, 0);
    const auto count = std::size_t(surface.mesh().vertexCount);
    const auto positions = surface.mesh().positions.read<glm::vec4>(count),
               normals = surface.mesh().normals.read<glm::vec4>(count);
    for (std::size_t i = 0; i < count; ++i) {
        const double x = double(positions[i].x), z = double(positions[i].z);
        // 25 texels a wave: a spline's own error is below 1e-4 of the height.
        EXPECT_NEAR(double(positions[i].y), ripple(x, z), 2e-6);
        const double slope = 0.01 * tau / 0.8 * std::cos(tau * (x / 0.8 + z / 1.1));
        EXPECT_NEAR(double(-normals[i].x / normals[i].y), slope, 1e-4);
    }
}

TEST(HostWaterGLTest, beyondItsEdgeTheSurfaceIsLevelAcrossIt) {
    gl::Context context;
    const HostTexture texture;
    texture.fill([](double x, double) { return 0.01 * x; });
    Water water;
    water.waves = {waveOf(texture.water())};
    WaterSurface surface(context);
    const WaterPatch patch{{4.3, -0.1}, {3, 2}, {8, 8}}; // beside it
    surface.update(water, patch, {}, 0);
    const auto count = std::size_t(surface.mesh().vertexCount);
    const auto positions = surface.mesh().positions.read<glm::vec4>(count),
               normals = surface.mesh().normals.read<glm::vec4>(count);
    for (std::size_t i = 0; i < count; ++i) {
        EXPECT_NEAR(positions[i].y, 0.01 * 2.3, 2e-4);
        EXPECT_NEAR(normals[i].y, 1, 1e-6);
    }
}

TEST(HostWaterGLTest, givesTheMapsOfTheSameWave) {
    Caustics caustics(Context::headless());
    Wave wave = scenes::cosine(0.01, 1, {0, 0});
    wave.direction = {1 / 0.8, 1 / 1.1};
    wave.wavelength = 1 / glm::length(wave.direction);
    wave.phase = -90;
    caustics.set(sceneOf({wave}));
    caustics.update(0);
    const std::vector<float> expected = caustics.irradiance(0);
    const HostTexture texture;
    texture.fill(ripple);
    caustics.set(sceneOf({waveOf(texture.water())}));
    caustics.update(0);
    EXPECT_LT(meanDifference(caustics.irradiance(0), expected), 0.002);
}

TEST(HostWaterGLTest, movesWithItsTextureThoughTimeStands) {
    Caustics caustics(Context::headless());
    const HostTexture texture;
    texture.fill([](double, double) { return 0.0; });
    const Wave wave = waveOf(texture.water());
    EXPECT_TRUE(moves(sceneOf({wave}).water));
    caustics.set(sceneOf({wave}));
    caustics.update(0);
    const std::vector<float> flat = caustics.irradiance(0);
    texture.fill(ripple);
    caustics.update(0);
    const std::vector<float> rippled = caustics.irradiance(0);
    EXPECT_GT(meanDifference(rippled, flat), 0.02);
    caustics.update(0);
    EXPECT_EQ(caustics.irradiance(0), rippled);
    Caustics fresh(Context::current());
    fresh.set(sceneOf({wave}));
    fresh.update(0);
    EXPECT_EQ(fresh.irradiance(0), rippled);
}

TEST(HostWaterGLTest, standsBesideOtherWavesInAnyPlace) {
    gl::Context context;
    const HostTexture texture;
    texture.fill(ripple);
    const auto heightsOf = [&](const std::vector<Wave>& waves) {
        Water water;
        water.waves = waves;
        WaterSurface surface(context);
        surface.update(water, {{0.3, -0.1}, {3, 2}, {20, 20}}, {}, 0);
        return surface.mesh().positions.read<glm::vec4>(std::size_t(surface.mesh().vertexCount));
    };
    const Wave wave = waveOf(texture.water());
    const auto once = heightsOf({wave}), twice = heightsOf({wave, wave});
    for (std::size_t i = 0; i < once.size(); ++i)
        EXPECT_NEAR(twice[i].y, 2 * once[i].y, 1e-7);
}

TEST(HostWaterGLTest, saysWhatItExpects) {
    Caustics caustics(Context::headless());
    HostTexture texture;
    HostWater water = texture.water();
    water.texture = 0;
    EXPECT_EQ(errorOf([&] { waveOf(water); }), "HostWater::texture: expected an OpenGL texture, got 0");
    water = texture.water();
    water.steepest = 0;
    EXPECT_EQ(errorOf([&] { waveOf(water); }), "HostWater::steepest: expected a finite number > 0, got 0");
    water = texture.water();
    water.texels.x = 8;
    EXPECT_EQ(errorOf([&] { waveOf(water); }), "HostWater::texels: expected 16 to 8192 a side, got 8");
    water.texels.x = 64;
    EXPECT_EQ(errorOf([&] { caustics.set(sceneOf({waveOf(water)})); }),
              "water.waves[0]: HostWater::texture: expected 64 x 96 texels, got 128 x 96");
    GLuint bytes = 0;
    glCreateTextures(GL_TEXTURE_2D, 1, &bytes);
    glTextureStorage2D(bytes, 1, GL_R8, texels.x, texels.y);
    water = texture.water();
    water.texture = bytes;
    EXPECT_EQ(errorOf([&] { caustics.set(sceneOf({waveOf(water)})); }),
              "water.waves[0]: HostWater::texture: expected format GL_R32F (0x822e), got 0x8229");
    const Wave wave = waveOf(texture.water());
    water.texture = bytes;
    glDeleteTextures(1, &bytes);
    EXPECT_THAT(errorOf([&] { caustics.set(sceneOf({waveOf(water)})); }),
                ::testing::HasSubstr("expected an OpenGL texture, got"));
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
}

} // namespace
} // namespace limpid
