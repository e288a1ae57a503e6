// Materials that let something show through, faces seen from behind, and what else a surface looks like.
#include <cmath>

#include "core/Optics.h"
#include "images/PictureFixture.h"

namespace limpid {
namespace {

const glm::dvec3 red(0.8, 0.1, 0.1), green(0.1, 0.8, 0.1), white(0.8);

/// A sheet 1 m wide, facing up, blended with `alpha` in `mode`.
Receiver sheet(const char* name, const glm::dvec3& color, double alpha, double y,
               AlphaMode mode = AlphaMode::Blend) {
    Mesh mesh = makePlane(glm::dvec2(1), glm::vec3(color));
    mesh.materials[0].baseColor.a = float(alpha);
    mesh.materials[0].alphaMode = mode;
    return scenes::shape(name, std::move(mesh), {0, y, 0});
}

class MaterialTest : public PictureFixture {
  protected:
    /// A floor and what lies over it, in ambient light alone, seen from straight above.
    static Scene over(std::vector<Receiver> receivers, double level) {
        Scene scene = floorFromAbove();
        scene.lights.clear();
        scene.ambientRadiance = glm::dvec3(1);
        scene.skyRadiance = glm::dvec3(0);
        scene.water.level = level;
        scene.caustics.mapSize = 64;
        for (Receiver& receiver : receivers)
            scene.receivers.push_back(std::move(receiver));
        return scene;
    }
    static void expectMiddle(const Scene& scene, const glm::dvec3& expected) {
        const Picture picture = render(scene, {16, 12});
        // Single precision; alpha itself is a float.
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(at(picture, 8, 6)[c], expected[c], 1e-5) << "channel " << c;
    }
};

TEST_F(MaterialTest, aSheetIsMixedWithWhatIsBehindIt) {
    expectMiddle(over({sheet("a", red, 0.25, -0.5)}, -3), 0.25 * red + 0.75 * white);
}

TEST_F(MaterialTest, underWaterLikewise) {
    const double out = optics::fresnelTransmittance(1.0, 1 / 1.333) / (1.333 * 1.333);
    const Picture picture = render(over({sheet("a", red, 0.25, -0.5)}, 0), {16, 12});
    const glm::dvec3 expected = out * (0.25 * red + 0.75 * white);
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(at(picture, 8, 6)[c] / expected[c], 1, 0.005); // Fresnel over a pixel's width
}

TEST_F(MaterialTest, theNearestSheetLiesOnTopWhateverTheOrder) {
    const glm::dvec3 expected = 0.5 * red + 0.5 * (0.5 * green + 0.5 * white);
    expectMiddle(over({sheet("a", red, 0.5, -0.3), sheet("b", green, 0.5, -0.6)}, -3), expected);
    expectMiddle(over({sheet("b", green, 0.5, -0.6), sheet("a", red, 0.5, -0.3)}, -3), expected);
}

TEST_F(MaterialTest, whatHidesAllHidesWhateverItsModeSays) {
    expectMiddle(over({sheet("a", red, 1, -0.5)}, -3), red);
    expectMiddle(over({sheet("a", red, 0.25, -0.5, AlphaMode::Opaque)}, -3), red);
    expectMiddle(over({sheet("a", red, 0, -0.5)}, -3), white);
    expectMiddle(over({sheet("a", red, 0.25, -0.5, AlphaMode::Mask)}, -3), white);
}

TEST_F(MaterialTest, somethingSolidHidesASheetBehindIt) {
    expectMiddle(over({sheet("a", red, 0.5, -0.6), sheet("b", green, 1, -0.3, AlphaMode::Opaque)}, -3),
                 green);
}

TEST_F(MaterialTest, lightIsAddedWithTheSheetsShare) {
    Scene scene = over({sheet("a", red, 0.25, -0.5)}, -3);
    scene.ambientRadiance = glm::dvec3(0);
    scene.lights = {scenes::sunAt(0)};
    scene.lights[0].irradiance = glm::dvec3(3.14159265358979);
    // It takes light as a hole does: what is behind it is lit as well.
    expectMiddle(scene, 0.25 * red + 0.75 * white);
}

TEST_F(MaterialTest, aSheetShowsFromBehind) {
    Scene scene = over({sheet("a", red, 0.25, 3)}, -3);
    scene.camera.target = {0, 3, 0}; // from 2 m: up
    expectMiddle(scene, 0.25 * red);
}

TEST_F(MaterialTest, waterBehindASheetShowsThroughIt) {
    Scene scene = over({sheet("a", red, 0.25, 0.5)}, 0);
    scene.water.absorption = glm::dvec3(1e4);
    scene.skyRadiance = glm::dvec3(1);
    // The water shows the sky by Fresnel's share, but for what the sheet takes from it on the way down.
    const double mirrors = 1 - optics::fresnelTransmittance(1.0, 1 / 1.333);
    const glm::dvec3 water = mirrors * (0.25 * red + 0.75 * glm::dvec3(1));
    const Picture picture = render(scene, {16, 12});
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(at(picture, 8, 6)[c], 0.25 * red[c] + 0.75 * water[c], 1e-4) << "channel " << c;
}

TEST_F(MaterialTest, theBackOfASheetIsInItsOwnShade) {
    Scene scene = over({sheet("a", red, 1, 3, AlphaMode::Opaque)}, -3);
    scene.ambientRadiance = glm::dvec3(0.1);
    scene.lights = {scenes::sunAt(0)};
    scene.camera.target = {0, 3, 0};
    expectMiddle(scene, 0.1 * red);
    scene.camera.position = {0, 4, 0};
    expectMiddle(scene, 0.1 * red + red / 3.14159265358979);
}

TEST_F(MaterialTest, aDarkVertexColorHasNoSteps) {
    Scene scene = over({}, -3);
    Mesh mesh = makePlane(glm::dvec2(4), glm::vec3(1));
    mesh.colors.assign(mesh.positions.size(), glm::vec4(0.0007f, 0.01f, 0.5f, 1));
    scene.receivers = {scenes::shape("floor", std::move(mesh), {0, -1, 0})};
    const Picture picture = render(scene, {16, 12});
    // Stored in steps of 1 / 65535.
    EXPECT_NEAR(at(picture, 8, 6).x, 0.0007, 0.5 / 65535 + 1e-7);
    EXPECT_NEAR(at(picture, 8, 6).y, 0.01, 0.5 / 65535 + 1e-7);
}

/// A normal map that leans all of a sheet by 45°, on the half of a second set of coordinates.
TEST_F(MaterialTest, aNormalMapLiesWhereItsOwnCoordinatesSay) {
    Scene scene = over({}, -3);
    scene.ambientRadiance = glm::dvec3(0);
    scene.lights = {scenes::sunAt(0)};
    Mesh mesh = makePlane(glm::dvec2(4), glm::vec3(1));
    mesh.images = {Image{2, 1, {128, 128, 255, 255, 218, 128, 218, 255}, false}};
    mesh.materials[0].normalImage = 0;
    mesh.materials[0].baseColorNearest = false;
    const auto lit = [&](double u) {
        Mesh moved = mesh;
        for (const glm::vec2& uv : moved.uvs)
            moved.normalUvs.emplace_back(float(u) + 1e-3f * uv.x, 0.5f + 1e-3f * uv.y);
        scene.receivers = {scenes::shape("floor", std::move(moved), {0, -1, 0})};
        return at(render(scene, {16, 12}), 8, 6).x * 3.14159265358979;
    };
    // 8 bits hold a direction to half a degree.
    EXPECT_NEAR(lit(0.25), 1, 0.01);
    EXPECT_NEAR(lit(0.75), std::sqrt(0.5), 0.01);
}

TEST_F(MaterialTest, aGlowAddsItsRadianceAndLightsNothing) {
    Receiver lamp = sheet("lamp", red, 1, -0.5, AlphaMode::Opaque);
    Mesh mesh = *lamp.mesh;
    mesh.materials[0].emission = {3, 0.5f, 0};
    mesh.images = {Image{1, 1, {255, 255, 0, 255}}};
    mesh.materials[0].emissionImage = 0;
    mesh.materials[0].emissionWrapS = Wrap::Clamp;
    lamp.mesh = std::make_shared<const Mesh>(mesh);
    const Scene scene = over({lamp}, -3);
    expectMiddle(scene, red + glm::dvec3(3, 0.5, 0));
    const Picture picture = render(scene, {16, 12});
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(at(picture, 1, 1)[c], white[c], 1e-5) << "beside it, channel " << c;
}

TEST_F(MaterialTest, aGlowUnderWaterIsDimmedOnItsWay) {
    Receiver lamp = sheet("lamp", glm::dvec3(0), 1, -0.5, AlphaMode::Opaque);
    Mesh mesh = *lamp.mesh;
    mesh.materials[0].emission = glm::vec3(2);
    lamp.mesh = std::make_shared<const Mesh>(mesh);
    Scene scene = over({lamp}, 0);
    scene.ambientRadiance = glm::dvec3(0);
    scene.water.absorption = {0.5, 1, 2};
    const double out = optics::fresnelTransmittance(1.0, 1 / 1.333) / (1.333 * 1.333);
    const Picture picture = render(scene, {16, 12});
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(at(picture, 8, 6)[c] / (2 * out * std::exp(-0.5 * scene.water.absorption[c])), 1, 0.005)
            << "Fresnel over a pixel's width, channel " << c;
}

} // namespace
} // namespace limpid
