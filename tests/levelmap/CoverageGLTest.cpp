#include "levelmap/Coverage.h"

#include "engine/EngineFixture.h"

namespace limpid {
namespace {

class CoverageGLTest : public EngineGLTest {
  protected:
    static constexpr int side = 64, places = 7;

    static Scene under(Receiver receiver) {
        Scene scene;
        scene.receivers = {std::move(receiver)};
        scene.lights = {scenes::sunAt(0)};
        scene.water.grid = {32, 32};
        scene.caustics.mapSize = side;
        return scene;
    }
    static std::vector<float> coverageOf(const Scene& scene) {
        Engine engine(context());
        engine.setScene(scene);
        engine.updateCaustics(0);
        return engine.coverage(engine.maps().at(0)).readFloats(GL_RED, 1);
    }
    static double sumOf(const std::vector<float>& numbers) {
        double sum = 0;
        for (const float x : numbers)
            sum += double(x);
        return sum;
    }
};

TEST_F(CoverageGLTest, aFloorFillsItsMap) {
    for (const float share : coverageOf(under(scenes::floorAt(-1))))
        EXPECT_EQ(share, 1);
}

// Half of a square. Places that its long side crosses, one in each row of them, are there or not: each is
// half a place wrong at most. Texels by their middles would be half a texel wrong.
TEST_F(CoverageGLTest, aTriangle) {
    Mesh mesh = makePlane({2, 2}, glm::vec3(0.8f));
    mesh.indices.resize(3);
    mesh.parts[0].indexCount = 3;
    const auto coverage = coverageOf(under(scenes::shape("triangle", std::move(mesh), {0, -1, 0})));
    ASSERT_EQ(coverage.size(), std::size_t(side * side));
    const double rounding = 1e-7 * side * side;
    EXPECT_NEAR(sumOf(coverage), 0.5 * side * side, 0.5 * side / places + rounding);
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
