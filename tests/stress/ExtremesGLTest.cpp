// Scenes at the ends of what there is: receivers without area, very many of everything, cameras where no eye
// fits.
#include "stress/StressFixture.h"

namespace limpid {
namespace {

class ExtremesGLTest : public StressTest {
  protected:
    static Scene floorUnderSun() {
        Scene scene;
        scene.receivers = {scenes::floorAt(-1)};
        scene.lights = {scenes::sunAt(0)};
        scene.water.grid = {32, 32};
        scene.caustics.mapSize = 64;
        scene.caustics.planes = 4;
        scene.caustics.photonGrid = {64, 64};
        return scene;
    }
    static Mesh meshOf(std::vector<glm::dvec3> corners) {
        Mesh mesh;
        mesh.positions = std::move(corners);
        mesh.normals.assign(mesh.positions.size(), {0, 1, 0});
        mesh.uvs.assign(mesh.positions.size(), {0, 0});
        for (std::uint32_t i = 0; i < mesh.positions.size(); ++i)
            mesh.indices.push_back(i);
        mesh.parts = {MeshPart{0, std::uint32_t(mesh.indices.size()), 0}};
        mesh.materials = {Material{}};
        return mesh;
    }
    static double openLight(const Scene& scene) { return bake(scene).maps.at(0).deposited; }
};

// What has no area takes no light, and throws no shade.
TEST_F(ExtremesGLTest, receiversWithoutArea) {
    const std::vector<std::vector<glm::dvec3>> shapes = {
        {},                                          // empty
        {{-0.5, 0, 0}, {0, 0, 0}, {0.5, 0, 0}},      // a line
        {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}},           // a point
        {{-0.5, -0.2, 0}, {0, 0, 0}, {0.5, 0.2, 0}}, // a line that leans
    };
    for (const Method method : allMethods())
        for (std::size_t i = 0; i < shapes.size(); ++i) {
            const std::string what = std::to_string(i) + " by " + std::string(methodName(method));
            Scene scene = floorUnderSun();
            scene.caustics.method = method;
            const double open = openLight(scene);
            scene.receivers.push_back(scenes::shape("thin", meshOf(shapes[i]), {0, -0.5, 0}));
            const Baked baked = bake(scene);
            expectLight(baked, what);
            EXPECT_NEAR(baked.maps.at(0).deposited, open, 1e-4 * open) << what;
            for (std::size_t m = 1; m < baked.maps.size(); ++m)
                EXPECT_EQ(baked.maps[m].deposited, 0) << what;
            EXPECT_EQ(impossible(engine().draw({32, 18}).rgb), 0u) << what;
        }
}

// A right triangle across the light: half a square's light, but for the texels that its long side crosses,
// each of which is told by its middle: no more than one in a row.
TEST_F(ExtremesGLTest, aSingleTriangle) {
    Scene scene = floorUnderSun();
    const double square = openLight(scene);
    scene.receivers = {scenes::shape("triangle", meshOf({{-1, 0, -1}, {-1, 0, 1}, {1, 0, -1}}), {0, -1, 0})};
    for (const Method method : {Method::ExactBeam, Method::LevelMap, Method::Volumetric, Method::Stencil}) {
        scene.caustics.method = method;
        EXPECT_NEAR(bake(scene).maps.at(0).deposited, 0.5 * square, square / 64) << methodName(method);
    }
}

TEST_F(ExtremesGLTest, nothingAtAll) {
    for (const Method method : allMethods()) {
        Scene scene;
        scene.caustics.method = method;
        scene.lights = {scenes::sunAt(30)};
        EXPECT_TRUE(bake(scene).maps.empty());
        EXPECT_EQ(impossible(engine().draw({32, 18}).rgb), 0u);
        scene.lights.clear();
        scene.receivers = {scenes::floorAt(-1)};
        expectLight(bake(scene), "no light");
        EXPECT_EQ(impossible(engine().draw({32, 18}).rgb), 0u);
    }
}

// Flat water over hills of a thousandth: what the floor's middle has.
TEST_F(ExtremesGLTest, twoMillionTriangles) {
    const std::uint32_t side = 1000;
    Mesh mesh;
    for (std::uint32_t z = 0; z <= side; ++z)
        for (std::uint32_t x = 0; x <= side; ++x) {
            mesh.positions.emplace_back(2.0 * x / side - 1, 1e-3 * std::sin(0.05 * x) * std::sin(0.05 * z),
                                        2.0 * z / side - 1);
            mesh.normals.emplace_back(0, 1, 0);
            mesh.uvs.emplace_back(0, 0);
        }
    for (std::uint32_t z = 0; z < side; ++z)
        for (std::uint32_t x = 0; x < side; ++x) {
            const std::uint32_t a = z * (side + 1) + x, b = a + 1, c = a + side + 1, d = c + 1;
            mesh.indices.insert(mesh.indices.end(), {a, c, b, b, c, d});
        }
    mesh.parts = {MeshPart{0, std::uint32_t(mesh.indices.size()), 0}};
    mesh.materials = {Material{}};
    ASSERT_EQ(mesh.triangleCount(), 2000000u);
    Scene scene = floorUnderSun();
    const double open = openLight(scene);
    scene.receivers = {scenes::shape("hills", std::move(mesh), {0, -1, 0})};
    const Baked baked = bake(scene);
    expectLight(baked, "hills");
    EXPECT_NEAR(baked.maps.at(0).deposited, open, 1e-4 * open);
}

// Tiles of a floor, side by side: each has its share, and all of them the floor's light.
TEST_F(ExtremesGLTest, aThousandReceivers) {
    Scene scene = floorUnderSun();
    const double open = openLight(scene);
    scene.receivers.clear();
    const Mesh tile = makePlane({2.0 / 40, 2.0 / 25}, glm::vec3(0.8f));
    const auto shared = std::make_shared<const Mesh>(tile);
    for (int i = 0; i < 1000; ++i) {
        Receiver receiver =
            scenes::shape("tile", {}, {(i % 40 + 0.5) / 20 - 1, -1, (i / 40 + 0.5) / 12.5 - 1});
        receiver.mesh = shared;
        scene.receivers.push_back(std::move(receiver));
    }
    scene.caustics.mapSize = 8;
    const Baked baked = bake(scene);
    ASSERT_EQ(baked.maps.size(), 1000u);
    expectLight(baked, "tiles");
    double sum = 0;
    for (const MapData& map : baked.maps)
        sum += map.deposited;
    // 5 by 8 texels each, without a rest.
    EXPECT_NEAR(sum, open, 1e-4 * open);
}

// All light of more than a million beams in four texels. Where the patch ends the water leans by 0.045: its
// transmittance is that of flat water but for 1e-6, and what lands leans by 0.011, whose cosine is 6e-5 off.
TEST_F(ExtremesGLTest, aMillionBeamsOnOnePlace) {
    Scene scene = stressScene("lens", 720, 64);
    const Baked baked = bake(scene);
    expectLight(baked, "lens");
    const double entering = 0.02 * 0.02 * 0.97963; // ((n - 1) / (n + 1))² is reflected
    EXPECT_NEAR(baked.maps.at(0).deposited, entering, 1e-4 * entering);
}

// More absorption, less light; in the end none.
TEST_F(ExtremesGLTest, absorptionUpToTenThousand) {
    for (const Method method : allMethods()) {
        Scene scene = floorUnderSun();
        scene.caustics.method = method;
        double before = openLight(scene);
        for (const double absorption : {0.01, 1.0, 100.0, 10000.0}) {
            scene.water.absorption = glm::dvec3(absorption);
            const Baked baked = bake(scene);
            expectLight(baked, "absorption");
            EXPECT_LE(baked.maps.at(0).deposited, before) << absorption << " by " << methodName(method);
            before = baked.maps[0].deposited;
        }
        EXPECT_EQ(before, 0) << methodName(method);
    }
}

TEST_F(ExtremesGLTest, camerasWhereNoEyeFits) {
    Scene scene = stressScene("emergent", 32, 32);
    bake(scene);
    const struct {
        glm::dvec3 position, target;
    } cameras[] = {
        {{0.6, 0.05, 0.3}, {0, -1, 0}}, // inside the ball
        {{1, 0, 1}, {0, -1, 0}},        // at the waterline
        {{1.5, 0, 0}, {-1, 0, 0}},      // along the water
        {{1.5, 1e-7, 0}, {-1, 0, 0}},   // a hair above
        {{0.5, -1, 0.5}, {-1, -1, 0}},  // in the floor
        {{0, 2, 0}, {0, -1, 1e-9}},     // straight down
    };
    for (const auto& [position, target] : cameras) {
        scene.camera.position = position;
        scene.camera.target = target;
        engine().set(scene);
        EXPECT_EQ(impossible(engine().draw({32, 18}).rgb), 0u) << position.x << " " << position.y;
    }
}

} // namespace
} // namespace limpid
