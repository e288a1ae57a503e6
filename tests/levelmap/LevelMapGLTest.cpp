#include "levelmap/LevelMap.h"

#include <cmath>

#include "engine/EngineFixture.h"

namespace limpid {
namespace {

class LevelMapGLTest : public EngineGLTest {
  protected:
    static Scene sphereUnderFlatWater(double degrees, int planes) {
        Scene scene;
        scene.receivers = {scenes::model("sphere", -2)};
        scene.lights = {scenes::sunAt(degrees)};
        scene.water.grid = {16, 16};
        scene.caustics.mapSize = 256;
        scene.caustics.planes = planes;
        scene.caustics.method = Method::LevelMapSmart;
        return scene;
    }
};

TEST_F(LevelMapGLTest, positionsLieOnTheReceiver) {
    for (const double degrees : {0.0, 40.0}) {
        const MapData map = bake(sphereUnderFlatWater(degrees, 50)).maps.at(0);
        int seen = 0;
        for (std::size_t i = 0; i < map.normalDotAxis.size(); ++i) {
            if (map.position[4 * i + 3] == 0) continue;
            ++seen;
            const glm::dvec3 p(map.position[4 * i], map.position[4 * i + 1], map.position[4 * i + 2]);
            // A sphere of 1,984 flat faces stays within 1 - cos(pi/32) · cos(pi/64) of its radius of 0.5.
            EXPECT_NEAR(glm::distance(p, glm::dvec3(0, -1.5, 0)), 0.497, 0.0035);
            const glm::dvec3 n(map.normal[3 * i], map.normal[3 * i + 1], map.normal[3 * i + 2]);
            EXPECT_NEAR(glm::length(n), 1, 1e-4);
            EXPECT_GT(glm::dot(n, glm::normalize(p - glm::dvec3(0, -1.5, 0))), 0.98);
        }
        EXPECT_NEAR(double(seen) / double(map.normalDotAxis.size()), M_PI / 4, 0.01)
            << "a disc in its square";
    }
}

TEST_F(LevelMapGLTest, rowsRunDownAndColumnsRight) {
    Scene scene = sphereUnderFlatWater(0, 3);
    const MapData map = bake(scene).maps.at(0);
    const auto at = [&](int x, int y) {
        const std::size_t i = 4 * (std::size_t(y) * std::size_t(map.size.x) + std::size_t(x));
        return glm::vec3(map.position[i], map.position[i + 1], map.position[i + 2]);
    };
    const int middle = map.size.x / 2;
    EXPECT_LT(at(middle / 2, middle).x, at(3 * middle / 2, middle).x)
        << "u goes right, along +x under a vertical sun";
    EXPECT_LT(at(middle, middle / 2).z, at(middle, 3 * middle / 2).z) << "row 0 is the far side, -z";
}

TEST_F(LevelMapGLTest, halfOfASpheresPlanesAreDropped) {
    // Thesis table 5-4 has 25 of 50 and 50 of about 100.
    for (const int planes : {50, 101}) {
        const int upright = bake(sphereUnderFlatWater(0, planes)).planesDrawn.at(0);
        EXPECT_NEAR(double(upright) / planes, 0.5, 0.03) << upright << " of " << planes;
        // Seen across its poles, the silhouette of 32 flat bands runs up to one half band past the equator,
        // and it ends within a plane's reach: that much more is really lit.
        const int tilted = bake(sphereUnderFlatWater(45, planes)).planesDrawn.at(0);
        const double band = 0.5 * std::sin(M_PI / 32);
        EXPECT_GE(double(tilted) / planes, 0.5);
        EXPECT_LE(double(tilted) / planes, 0.5 + band + 1.0 / planes) << tilted << " of " << planes;
    }
}

TEST_F(LevelMapGLTest, histogramCountsEveryTexelOnce) {
    Engine& engine = sharedEngine();
    Scene scene = sphereUnderFlatWater(0, 50);
    scene.caustics.method = Method::LevelMap;
    const Baked baked = bake(engine, scene);
    SmartSlicing slicing(context());
    std::uint64_t texels = 0;
    for (const float alpha : baked.maps[0].normalDotAxis)
        texels += alpha > 0;
    for (const int levels : {0, 1, 64}) {
        std::uint64_t counted = 0;
        for (const std::uint32_t count : slicing.histogram(engine.maps()[0].level, levels))
            counted += count;
        EXPECT_EQ(counted, texels) << levels;
    }
}

TEST_F(LevelMapGLTest, theThesissOwnSlicingFollowsItsThreshold) {
    Scene scene = sphereUnderFlatWater(0, 50);
    scene.caustics.slicing = Slicing::Levels;
    scene.caustics.depthLevels = 64;
    scene.caustics.threshold = 0.01;
    const Baked baked = bake(scene);
    // Half of the levels (32, or 33 where the silhouette touches the next) are valid: 0.5 / 0.02 planes.
    EXPECT_NEAR(baked.planesDrawn.at(0), 25, 1);
    const Baked uniform = bake(sphereUnderFlatWater(0, 50));
    EXPECT_NEAR(baked.maps[0].deposited / uniform.maps[0].deposited, 1, 1e-3);
}

TEST_F(LevelMapGLTest, memoryDoesNotGrowWithPlanes) {
    std::int64_t first = 0;
    for (const int planes : {3, 17, 101}) {
        Engine& engine = sharedEngine();
        Scene scene = sphereUnderFlatWater(0, planes);
        scene.caustics.method = Method::LevelMap;
        bake(engine, scene);
        const std::int64_t bytes = context().ledger().total();
        if (first == 0) first = bytes;
        EXPECT_EQ(bytes, first) << planes << " planes";
        EXPECT_EQ(context().ledger().bytes("position map"), 256 * 256 * 8);
    }
}

TEST_F(LevelMapGLTest, aReceiverOfNoHeightHasOnePlane) {
    Scene scene = sphereUnderFlatWater(0, 50);
    scene.receivers = {scenes::floorAt(-1)};
    scene.caustics.method = Method::LevelMap;
    const Baked baked = bake(scene);
    EXPECT_EQ(baked.planesDrawn.at(0), 1);
    EXPECT_EQ(baked.planesRequested.at(0), 50);
    EXPECT_NEAR(baked.frames[0].box.extent.z, 2e-4, 1e-9);
}

TEST_F(LevelMapGLTest, theMapShowsBaseColour) {
    Engine& engine = sharedEngine();
    Scene scene = sphereUnderFlatWater(0, 3);
    scene.receivers = {scenes::shape("red", makeSphere(0.5, {0.5f, 0.1f, 0.02f}), {0, -1, 0})};
    bake(engine, scene);
    const auto diffuse = engine.maps()[0].level.diffuse.readFloats(GL_RGBA, 4);
    const std::size_t center = 4 * (128 * 256 + 128);
    // sRGB in 8 bits comes back as stored.
    EXPECT_NEAR(diffuse[center], 0.735, 0.01);
    EXPECT_NEAR(diffuse[center + 1], 0.349, 0.01);
    EXPECT_EQ(diffuse[center + 3], 1) << "all of the light arrives";
}

} // namespace
} // namespace limpid
