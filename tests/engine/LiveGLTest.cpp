// What a program that shows a scene while it changes relies on: pictures in pieces, and what is kept from one
// scene to the next. All bit for bit.
#include <array>
#include <set>

#include "core/Error.h"
#include "engine/EngineFixture.h"

namespace limpid {

namespace {

class LiveGLTest : public EngineGLTest {
  protected:
    static Scene pond() {
        Scene scene;
        scene.receivers = {scenes::floorAt(-0.6),
                           scenes::shape("ball", makeSphere(0.3, glm::vec3(0.8f)), {0, -0.2, 0})};
        scene.lights = {scenes::sunAt(30)};
        scene.water.grid = {24, 24};
        scene.water.waves = {scenes::cosine(0.01, 0.5, {1, 0.3})};
        scene.caustics.mapSize = 64;
        scene.camera.position = {0.4, 1.1, 1.6};
        scene.camera.target = {0, -0.2, 0};
        return scene;
    }
    static std::vector<float> samples(const PicturePass::Sketch& sketch) {
        return sketch.samples().readFloats(GL_RGBA, 4);
    }
    static Picture fresh(const Scene& scene, glm::ivec2 size) {
        Engine engine(context());
        engine.set(scene);
        return engine.render(0, size);
    }
    static constexpr glm::ivec2 size{48, 32};
};

TEST_F(LiveGLTest, rowsAddUpToThePicture) {
    Engine engine(context());
    engine.set(pond());
    engine.updateCaustics(0);
    const auto whole = engine.beginPicture(size, 2);
    engine.drawRows(whole, {0, size.y});
    const auto pieces = engine.beginPicture(size, 2);
    for (const glm::ivec2 rows : {glm::ivec2(20, 32), glm::ivec2(0, 7), glm::ivec2(7, 20)})
        engine.drawRows(pieces, rows);
    EXPECT_EQ(samples(whole), samples(pieces));
    EXPECT_EQ(pieces.samples().size(), 2 * size);

    // Each pixel of a picture is the mean of its four samples; it counts rows from the top.
    const Picture picture = engine.draw(size);
    const auto all = samples(whole);
    const auto sample = [&](int x, int y) { return all[std::size_t(4 * (y * 2 * size.x + x))]; };
    const int x = 24, y = 16, up = size.y - 1 - y;
    const float mean = 0.25f * (sample(2 * x, 2 * up) + sample(2 * x + 1, 2 * up) +
                                sample(2 * x, 2 * up + 1) + sample(2 * x + 1, 2 * up + 1));
    EXPECT_FLOAT_EQ(picture.rgb[std::size_t(3 * (y * size.x + x))], mean);
}

/// Which passes ran since the last call, but for the picture's.
static std::set<std::string> passes(Engine& engine) {
    std::set<std::string> names;
    for (const auto& [pass, ms] : engine.timers().collect())
        if (pass != "picture") names.insert(pass);
    return names;
}

TEST_F(LiveGLTest, onlyWhatComesOutOtherwiseIsMadeAgain) {
    Engine engine(context());
    Scene scene = pond();
    scene.lights[0].angularDiameter = 2;
    engine.set(scene);
    engine.render(0, size);
    passes(engine);
    using Passes = std::set<std::string>;
    const auto after = [&](auto&& change) {
        change(scene);
        engine.set(scene);
        const Picture picture = engine.render(0, size);
        EXPECT_EQ(picture.rgb, fresh(scene, size).rgb);
        return passes(engine);
    };
    EXPECT_EQ(after([](Scene&) {}), Passes());
    EXPECT_EQ(after([](Scene& s) { s.lights[0].name = "moon", s.receivers[1].name = "buoy"; }), Passes());
    EXPECT_EQ(after([](Scene& s) { s.lights[0].irradiance = {1, 0.5, 0.25}; }), (Passes{"caustic map"}));
    EXPECT_EQ(after([](Scene& s) { s.water.absorption = {0.3, 0.1, 0.2}; }), (Passes{"caustic map"}));
    EXPECT_EQ(after([](Scene& s) { s.lights[0].irradiance = glm::dvec3(0); }), Passes()) << "nothing shows";
}

TEST_F(LiveGLTest, aReceiverThatMovesTakesAlongWhatItShades) {
    Engine engine(context());
    Scene scene = pond();
    scene.water.center = glm::dvec2(0);
    scene.water.size = glm::dvec2(3);
    scene.lights = {scenes::sunAt(0)};
    scene.receivers = {scenes::floorAt(-1, 0.5)};
    for (int i = 0; i < 4; ++i)
        scene.receivers.push_back(
            scenes::shape("ball", makeSphere(0.1, glm::vec3(0.8f)), {0.6 * i - 0.8, -0.4 - 0.1 * i, 0.6}));
    const auto stamps = [&] {
        std::vector<std::array<Stamp, 2>> all;
        for (const MapWork& map : engine.maps())
            all.push_back({map.drawn.stamp(), map.filled.stamp()});
        return all;
    };
    const auto made = [&](int receiver, const glm::dvec3& to) {
        const auto before = stamps();
        scene.receivers[std::size_t(receiver)].translation = to;
        engine.set(scene);
        engine.updateCaustics(0);
        const auto after = stamps();
        std::vector<std::string> what;
        for (std::size_t i = 0; i < after.size(); ++i)
            what.push_back((after[i][0] != before[i][0] ? "drawn " : "") +
                           std::string(after[i][1] != before[i][1] ? "filled" : ""));
        Engine anew(context());
        anew.set(scene);
        anew.updateCaustics(0);
        for (std::size_t i = 0; i < after.size(); ++i)
            EXPECT_EQ(readMaps(engine.maps()[i], engine.origin()).irradiance,
                      readMaps(anew.maps()[i], anew.origin()).irradiance)
                << "map " << i;
        return what;
    };
    engine.set(scene);
    engine.updateCaustics(0);
    using Made = std::vector<std::string>;
    ASSERT_EQ(engine.maps().size(), 5u);
    EXPECT_EQ(made(2, {-0.2, -0.5, 0.7}), (Made{"", "", "drawn filled", "", ""})) << "it shades nothing";
    EXPECT_EQ(made(2, {0, -0.5, 0}), (Made{"filled", "", "drawn filled", "", ""})) << "over the floor";
    EXPECT_EQ(made(2, {0.05, -0.5, 0}), (Made{"filled", "", "drawn filled", "", ""}));
    EXPECT_EQ(made(2, {-0.2, -0.5, 0.7}), (Made{"filled", "", "drawn filled", "", ""})) << "its shade goes";
}

TEST_F(LiveGLTest, anotherLookKeepsTheLight) {
    Engine engine(context());
    const Scene scene = pond();
    engine.set(scene);
    engine.updateCaustics(0);
    engine.draw(size);
    const GLuint caustics = engine.maps()[0].caustics.irradiance.id();
    engine.timers().collect();
    Scene other = scene;
    other.camera.position = {-1.2, 0.8, 0.9};
    other.skyRadiance = {1, 0, 0};
    other.ambientRadiance = {0, 0.5, 0};
    engine.set(other);
    const Picture picture = engine.render(0, size);
    EXPECT_EQ(engine.maps()[0].caustics.irradiance.id(), caustics);
    for (const auto& [pass, ms] : engine.timers().collect())
        EXPECT_EQ(pass, "picture");
    EXPECT_EQ(picture.rgb, fresh(other, size).rgb);
}

TEST_F(LiveGLTest, aSceneLeavesNothingBehind) {
    Engine engine(context());
    engine.set(pond());
    engine.render(0, size);
    Scene other = pond();
    other.receivers[1].translation.x = 0.3;
    other.water.waves[0].amplitude = 0.02;
    other.water.level = 0.2;
    other.caustics.mapSize = 48;
    engine.set(other);
    EXPECT_EQ(engine.render(0, size).rgb, fresh(other, size).rgb);
    other.receivers.erase(other.receivers.begin());
    engine.set(other);
    EXPECT_EQ(engine.render(0, size).rgb, fresh(other, size).rgb);
}

TEST_F(LiveGLTest, aSceneThatCannotBeLeavesTheOneBefore) {
    Engine engine(context());
    const Scene scene = pond();
    engine.set(scene);
    const Picture before = engine.render(0, size);
    Scene tooFine = scene;
    tooFine.water.grid = {8192, 8192};
    EXPECT_THROW(engine.set(tooFine), InputError);
    EXPECT_EQ(engine.scene(), scene);
    EXPECT_EQ(engine.render(0, size).rgb, before.rgb);
}

} // namespace
} // namespace limpid
