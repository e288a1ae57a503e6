#include <numeric>

#include "engine/EngineFixture.h"

namespace limpid {
namespace {

class ReadbackGLTest : public EngineGLTest {
  protected:
    static Scene sphere() {
        Scene scene;
        scene.receivers = {scenes::model("sphere", -1.5)};
        scene.lights = {scenes::sunAt(0)};
        scene.water.grid = {16, 16};
        scene.caustics.mapSize = 64;
        scene.caustics.method = Method::LevelMapSmart;
        scene.caustics.planes = 33;
        scene.caustics.photonGrid = {40, 40};
        return scene;
    }
};

// It is what slicing counts on the GPU, so the planes that it drops are the empty ones.
TEST_F(ReadbackGLTest, planeHistogramHasTheTexelsOfEachPlane) {
    Engine engine(context());
    engine.set(sphere());
    engine.updateCaustics(0);
    const MapWork& maps = engine.maps().front();
    const auto histogram = planeHistogram(maps.level);
    ASSERT_EQ(histogram.size(), 33u);
    std::size_t occupied = 0;
    for (std::size_t plane = 0; plane < histogram.size(); ++plane)
        if (histogram[plane] > 0) {
            ASSERT_LT(occupied, maps.level.planes.size());
            EXPECT_EQ(maps.level.planes[occupied++].index, int(plane));
        }
    EXPECT_EQ(occupied, maps.level.planes.size());
    const MapData data = readMaps(maps, engine.origin());
    std::size_t seen = 0;
    for (std::size_t i = 3; i < data.position.size(); i += 4)
        seen += data.position[i] > 0;
    EXPECT_EQ(std::accumulate(histogram.begin(), histogram.end(), std::size_t(0)), seen)
        << "a sphere alone shades nothing that the light sees";
}

// Memory by kind is what the method at hand takes, not what ran before it.
TEST_F(ReadbackGLTest, otherSettingsLeaveNothingOfTheOnesBefore) {
    Scene scene = sphere();
    const auto bytes = [](Engine& engine) {
        engine.updateCaustics(0);
        return context().ledger().byKind();
    };
    const auto before = context().ledger().byKind();
    std::map<Method, std::map<std::string, std::int64_t, std::less<>>> alone;
    for (const Method method : allMethods()) {
        scene.caustics.method = method;
        Engine engine(context());
        engine.set(scene);
        alone[method] = bytes(engine);
        EXPECT_NE(alone[method], before);
    }
    EXPECT_EQ(context().ledger().byKind(), before);
    Engine engine(context());
    engine.set(scene);
    for (const Method method : allMethods()) {
        scene.caustics.method = method;
        engine.set(scene);
        EXPECT_EQ(bytes(engine), alone[method]) << methodName(method);
    }
}

TEST_F(ReadbackGLTest, otherSettingsOfTheSameSceneAreThoseOfAFreshOne) {
    Engine engine(context());
    engine.set(sphere());
    engine.updateCaustics(0);
    Scene scene = sphere();
    scene.caustics.method = Method::LevelMap;
    scene.caustics.planes = 7;
    scene.caustics.mapSize = 48;
    engine.set(scene);
    engine.updateCaustics(0);
    const Baked fresh = bake(scene);
    ASSERT_EQ(engine.maps().size(), fresh.maps.size());
    for (std::size_t i = 0; i < fresh.maps.size(); ++i) {
        EXPECT_EQ(readMaps(engine.maps()[i], engine.origin()).irradiance, fresh.maps[i].irradiance);
        EXPECT_EQ(int(engine.maps()[i].level.planes.size()), 7);
    }
}

} // namespace
} // namespace limpid
