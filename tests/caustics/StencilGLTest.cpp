#include <cmath>

#include "core/Optics.h"
#include "engine/EngineFixture.h"

namespace limpid {
namespace {

class StencilGLTest : public EngineGLTest {
  protected:
    /// Waves that focus above the floor and within the sphere's depths.
    static Scene floorPastSphere() {
        Scene scene = scenes::floorPastSphere(45);
        scene.water.waves = {scenes::cosine(0.01, 0.3, {1, 0.4}), scenes::noise(0.01, 0.5)};
        scene.caustics.mapSize = 128;
        return scene;
    }
    static Baked bakeBy(Method method, Scene scene) {
        scene.caustics.method = method;
        return bake(scene);
    }
};

TEST_F(StencilGLTest, countsEachTexelInOneSubVolume) {
    // Under flat water no light is focused, and a texel has E cosθ T / cosθr · |n·V| (physics: the cosine by
    // the light of flat water is then exact). A texel that no volume took would have nothing, one that two
    // took twice as much.
    for (const int planes : {1, 2, 7, 60}) {
        Scene scene;
        scene.receivers = {scenes::shape("ball", makeSphere(0.5, glm::vec3(1)), {0, -1, 0})};
        scene.lights = {scenes::sunAt(40)};
        scene.water.grid = {37, 41};
        scene.caustics.mapSize = 100;
        scene.caustics.planes = planes;
        const Baked baked = bakeBy(Method::Stencil, scene);
        const MapData& map = baked.maps.at(0);
        const double cosine = std::cos(glm::radians(40.0));
        const double refracted = std::cos(std::asin(std::sin(glm::radians(40.0)) / 1.333));
        const double across = cosine * optics::fresnelTransmittance(cosine, 1 / 1.333) / refracted;
        int seen = 0;
        for (std::size_t i = 0; i < map.normalDotAxis.size(); ++i) {
            if (map.position[4 * i + 3] == 0) continue;
            ++seen;
            // Normals are read back with 16 bits: 1e-4 of them counts where the face is steep.
            ASSERT_NEAR(map.irradiance[3 * i], across * double(map.normalDotAxis[i]), 1e-3)
                << "texel " << i << ", " << planes << " sub-volumes";
        }
        EXPECT_GT(seen, 7000);
    }
}

TEST_F(StencilGLTest, takesWhatRasterisersTakeOnAFloor) {
    // A floor across the light has one depth, and the count is that of the caustic triangles there
    // (Iwasaki 4.2): the level map's. Corners snap to 1/256 texel a little above and below the floor in place
    // of on it, so a texel may differ where an edge passes within 1/256 of its centre: triangles with sides
    // of 6, 6 and 8.5 texels have (6 + 6 + 8.5) / 2 of edges in an area of 18, of which a strip of 2/256 is
    // 0.45 %.
    Scene scene;
    scene.receivers = {scenes::floorAt(-1, 1)};
    scene.lights = {scenes::sunAt(0)};
    scene.water.waves = {scenes::cosine(0.004, 0.2, {1, 0})};
    scene.water.center = glm::dvec2(0);
    scene.water.size = glm::dvec2(1.09);
    scene.water.grid = {46, 46};
    scene.caustics.mapSize = 256;
    const MapData drawn = bakeBy(Method::LevelMap, scene).maps.at(0);
    const MapData tested = bakeBy(Method::Stencil, scene).maps.at(0);
    int differing = 0;
    for (std::size_t i = 0; i < 256 * 256; ++i)
        differing +=
            std::abs(drawn.irradiance[3 * i] - tested.irradiance[3 * i]) > 2e-3f * drawn.irradiance[3 * i];
    printf("%.3f %% of the texels differ\n", 100 * differing / 65536.0);
    EXPECT_LT(differing, 0.0045 * 256 * 256);
}

TEST_F(StencilGLTest, losesNoFocus) {
    // What it adds is flux over the cross-section at the texel's depth, and so all of the flux up to what
    // sampling at texel centres makes of it: half a percent here, as with the level map on fine planes.
    Scene scene = floorPastSphere();
    scene.caustics.planes = 40;
    const Baked drawn = bakeBy(Method::LevelMap, scene), exact = bakeBy(Method::ExactBeam, scene);
    const Baked tested = bakeBy(Method::Stencil, scene);
    for (std::size_t i = 0; i < 2; ++i) {
        printf("%s: flux %.4f of exact beams', level map %.4f\n", i == 0 ? "floor" : "sphere",
               tested.maps[i].deposited / exact.maps[i].deposited,
               drawn.maps[i].deposited / exact.maps[i].deposited);
        EXPECT_NEAR(tested.maps[i].deposited, drawn.maps[i].deposited, 0.01 * drawn.maps[i].deposited);
    }
}

TEST_F(StencilGLTest, everyRunGivesTheSameBits) {
    Scene scene = floorPastSphere();
    scene.water.absorption = {0.4, 0.1, 0.05};
    scene.caustics.planes = 9;
    scene.caustics.method = Method::Stencil;
    const Baked a = bakeAfresh(scene), b = bakeAfresh(scene);
    for (std::size_t i = 0; i < a.maps.size(); ++i)
        EXPECT_EQ(a.maps[i].irradiance, b.maps[i].irradiance);
}

TEST_F(StencilGLTest, absorbsByColour) {
    Scene scene;
    scene.receivers = {scenes::floorAt(-1, 1)};
    scene.lights = {scenes::sunAt(0)};
    scene.water.grid = {16, 16};
    scene.water.absorption = {0.5, 0.25, 0};
    scene.caustics.mapSize = 64;
    const MapData map = bakeBy(Method::Stencil, scene).maps.at(0);
    const std::size_t middle = 3 * (32 * 64 + 32);
    EXPECT_NEAR(map.irradiance[middle] / map.irradiance[middle + 2], std::exp(-0.5), 1e-3);
    EXPECT_NEAR(map.irradiance[middle + 1] / map.irradiance[middle + 2], std::exp(-0.25), 1e-3);
}

} // namespace
} // namespace limpid
