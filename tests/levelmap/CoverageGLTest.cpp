#include "levelmap/Coverage.h"

#include <algorithm>
#include <cmath>

#include "engine/EngineFixture.h"

namespace limpid {
namespace {

class CoverageGLTest : public EngineGLTest {
  protected:
    static constexpr int side = 64, places = 5; // along a texel's side, at least

    static Scene under(Receiver receiver) {
        Scene scene;
        scene.receivers = {std::move(receiver)};
        scene.lights = {scenes::sunAt(0)};
        scene.water.grid = {32, 32};
        scene.caustics.mapSize = side;
        return scene;
    }
    static std::vector<float> coverageOf(const Scene& scene) {
        Engine& engine = sharedEngine();
        engine.set(scene);
        engine.updateCaustics(0);
        return engine.coverage(engine.maps().at(0)).readFloats(GL_RED, 1);
    }
};

TEST_F(CoverageGLTest, aFloorFillsItsMap) {
    // Corners snap to 1/256 of a place or finer: at a rim a place or two of a texel may be lost to that.
    double sum = 0;
    for (const float share : coverageOf(under(scenes::floorAt(-1)))) {
        EXPECT_GE(share, 1 - 2.2 / (places * places));
        sum += double(share);
    }
    EXPECT_NEAR(sum, side * side, 4 * side * places / 256.0 / (places * places));
}

// Half of a square: texels within it are whole; of those that its long side crosses, where the map has them,
// half is there, give or take the places that it passes.
TEST_F(CoverageGLTest, aTriangle) {
    Mesh mesh = makePlane({2, 2}, glm::vec3(0.8f));
    mesh.indices.resize(3);
    mesh.parts[0].indexCount = 3;
    const auto coverage = coverageOf(under(scenes::shape("triangle", std::move(mesh), {0, -1, 0})));
    ASSERT_EQ(coverage.size(), std::size_t(side * side));
    const auto isWhole = [](float share) { return share > 1 - 2.2 / (places * places); };
    EXPECT_EQ(std::count_if(coverage.begin(), coverage.end(), isWhole), side * (side - 1) / 2);
    double inPart = 0, sum = 0;
    for (const float share : coverage)
        if (share > 0 && !isWhole(share)) {
            EXPECT_NEAR(share, 0.5, 1.0 / places);
            ++inPart, sum += double(share);
        }
    EXPECT_NEAR(sum, 0.5 * inPart, 0.5 * std::sqrt(inPart) / places);
}

// A slab over a floor, in one mesh, whose edges run through texels: the slab's texels end where it does, and
// those of the floor beside it begin there.
TEST_F(CoverageGLTest, ofAStepEachTexelHasItsOwnPart) {
    const double edge = 0.3 / side; // 0.15 of a texel right of where one begins
    Mesh mesh = makePlane({2, 2}, glm::vec3(0.8f));
    const std::uint32_t first = std::uint32_t(mesh.positions.size());
    for (const auto& [x, z] : {std::pair{-1.0, -1.0}, {-1.0, 1.0}, {edge, 1.0}, {edge, -1.0}}) {
        mesh.positions.emplace_back(x, 0.3, z);
        mesh.normals.emplace_back(0, 1, 0);
        mesh.uvs.emplace_back(0, 0);
    }
    for (const std::uint32_t i : {0, 1, 2, 0, 2, 3})
        mesh.indices.push_back(first + i);
    mesh.parts[0].indexCount += 6;
    const auto coverage = coverageOf(under(scenes::shape("step", std::move(mesh), {0, -1, 0})));
    // The texel's middle is right of the edge: it shows the floor, 1 - 0.15 of it.
    int inPart = 0;
    double sum = 0;
    for (const float share : coverage)
        if (share < 0.95f) {
            ++inPart, sum += double(share);
            EXPECT_NEAR(share, 0.85, 1.0 / places);
        }
    EXPECT_EQ(inPart, side);
    // The edge meets another part of the places in each texel.
    EXPECT_NEAR(sum, 0.85 * side, 0.5 * std::sqrt(side) / places);
}

// Where the map has a texel, some of the receiver is in it.
TEST_F(CoverageGLTest, everyTexelOfTheMapIsCoveredInPart) {
    const Scene scene = under(scenes::shape("ball", makeSphere(0.3, glm::vec3(0.8f)), {0, -1, 0}));
    const auto coverage = coverageOf(scene);
    const MapData map = bake(scene).maps.at(0);
    int inPart = 0;
    for (std::size_t i = 0; i < coverage.size(); ++i) {
        EXPECT_TRUE(map.position[4 * i + 3] == 0 || coverage[i] > 0) << i;
        inPart += coverage[i] > 0 && coverage[i] < 1 ? 1 : 0;
    }
    // At least a texel in each row, left and right.
    EXPECT_GE(inPart, 2 * side);
}

} // namespace
} // namespace limpid
