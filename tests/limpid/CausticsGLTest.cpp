// The public face: the same maps as the engine, and words for what a host may get wrong.
#include <cmath>
#include <limits>

#include <gmock/gmock.h>

#include "core/ErrorOf.h"
#include "engine/Readback.h"
#include "engine/Scenes.h"
#include "limpid/Caustics.h"

namespace limpid {
namespace {

Scene rippledFloor() {
    Scene scene = scenes::floorPastSphere(30);
    scene.water.waves = {scenes::cosine(0.01, 0.5, {1, 0.3})};
    scene.caustics.mapSize = 64;
    return scene;
}

using test::errorOf;

TEST(CausticsGLTest, mapsAreTheEngines) {
    std::vector<float> expected;
    {
        gl::Context context;
        Engine engine(context);
        engine.set(rippledFloor());
        engine.updateCaustics(0.5);
        expected = readMaps(engine.maps()[0], engine.origin()).irradiance;
    }
    const Context context = Context::headless();
    Caustics caustics(context);
    caustics.set(rippledFloor());
    caustics.update(0.5);
    const std::vector<LitMap> maps = caustics.maps();
    ASSERT_FALSE(maps.empty());
    EXPECT_GT(maps[0].irradiance, 0u);
    EXPECT_GT(maps[0].depth, 0);
    EXPECT_EQ(caustics.irradiance(0), expected);
    EXPECT_GT(context.bytes(), 0);
}

TEST(CausticsGLTest, theMatrixPutsAReceiversMiddleIntoItsMap) {
    Caustics caustics(Context::headless());
    caustics.set(rippledFloor());
    caustics.update(0);
    const LitMap map = caustics.maps()[0];
    const Receiver& receiver = caustics.scene().receivers[std::size_t(map.receiver)];
    const glm::vec4 place = map.worldToTexture * glm::vec4(receiver.translation - map.origin, 1);
    for (int c = 0; c < 3; ++c) {
        EXPECT_GE(place[c], 0);
        EXPECT_LE(place[c], 1);
    }
}

TEST(CausticsGLTest, rendersAndThenAsksForAnUpdate) {
    Caustics caustics(Context::headless());
    caustics.set(rippledFloor());
    caustics.update(0);
    const Picture picture = caustics.render(0, {32, 16});
    EXPECT_EQ(picture.rgb.size(), 3u * 32 * 16);
    EXPECT_EQ(errorOf([&] { caustics.maps(); }),
              "maps: expected update() since the last set() or render(), got no such call");
    caustics.update(0);
    EXPECT_FALSE(caustics.maps().empty());
}

TEST(CausticsGLTest, saysWhatItExpectsOfCalls) {
    Caustics caustics(Context::headless());
    EXPECT_EQ(errorOf([&] { caustics.update(0); }), "update: expected set() before it, got no such call");
    caustics.set(rippledFloor());
    EXPECT_EQ(errorOf([&] { caustics.update(std::nan("")); }), "seconds: expected a finite number, got nan");
    EXPECT_THAT(errorOf([&] { caustics.render(0, {0, 10}); }), ::testing::EndsWith("got 0 x 10"));
    caustics.update(0);
    EXPECT_THAT(errorOf([&] { caustics.irradiance(99); }), ::testing::EndsWith("got 99"));
    EXPECT_EQ(errorOf([&] { Context::headless({.memory = -1}); }),
              "ContextOptions::memory: expected bytes >= 0, got -1");
}

TEST(CausticsGLTest, saysWhatIsWrongInASceneAndKeepsTheOneBefore) {
    Caustics caustics(Context::headless());
    caustics.set(rippledFloor());
    const auto refuses = [&](const std::string& expected, const auto& spoil) {
        Scene scene = rippledFloor();
        spoil(scene);
        EXPECT_EQ(errorOf([&] { caustics.set(scene); }), expected);
    };
    refuses("receivers[0].mesh: expected a mesh, got none", [](Scene& s) { s.receivers[0].mesh = nullptr; });
    refuses("caustics.mapSize: expected a number in [1, 16384], got 0",
            [](Scene& s) { s.caustics.mapSize = 0; });
    refuses("water.ior: expected a number in [1, 4], got 0.5", [](Scene& s) { s.water.ior = 0.5; });
    refuses("lights[0].direction: expected a direction of a length > 0, got 0",
            [](Scene& s) { s.lights[0].direction = glm::dvec3(0); });
    refuses("camera.verticalFov: expected a number in (0, 180), got 180",
            [](Scene& s) { s.camera.verticalFov = 180; });
    refuses("receivers[0].mesh.indices[0]: expected an index from 0 to 3, got 7", [](Scene& s) {
        Mesh mesh = *s.receivers[0].mesh;
        mesh.indices[0] = 7;
        s.receivers[0].mesh = std::make_shared<const Mesh>(mesh);
    });
    refuses("water.waves[0].heights: expected a source of heights, got none",
            [](Scene& s) { s.water.waves[0].type = WaveType::HeightMap; });
    EXPECT_EQ(caustics.scene().receivers.size(), rippledFloor().receivers.size());
    caustics.update(0);
    EXPECT_FALSE(caustics.maps().empty());
}

TEST(CausticsGLTest, inAnotherContextTheErrorSaysSo) {
    const Context first = Context::headless();
    auto caustics = std::make_unique<Caustics>(first);
    caustics->set(rippledFloor());
    const Context second = Context::headless(); // current from here on
    try {
        caustics->update(0);
        FAIL();
    } catch (const GraphicsError& error) {
        EXPECT_THAT(error.what(), ::testing::StartsWith("OpenGL: expected context 0x"));
    }
    EXPECT_THROW(Caustics{first}, GraphicsError);
    caustics.reset(); // in some context; the first's objects go with it
}

TEST(CausticsGLTest, withoutAContextTheErrorSaysSo) {
    try {
        Context::current();
        FAIL();
    } catch (const GraphicsError& error) {
        EXPECT_STREQ(error.what(), "OpenGL: expected a context that is current on this thread, found none");
    }
}

} // namespace
} // namespace limpid
