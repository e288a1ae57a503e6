#include <algorithm>
#include <cmath>

#include "engine/EngineFixture.h"
#include "scene/MethodFacts.h"

namespace limpid {
namespace {

/// Skipping leaves out work and changes no bit of what is made.
class SkippingGLTest : public EngineGLTest {
  protected:
    static Scene waves(std::vector<Receiver> receivers) {
        Scene scene;
        scene.receivers = std::move(receivers);
        scene.lights = {scenes::sunAt(25)};
        scene.water.waves = {scenes::cosine(0.008, 0.35, {1, 0.4}), scenes::noise(0.02, 0.5)};
        scene.water.waves[0].speed = 0.3;
        scene.water.grid = {32, 32};
        scene.caustics.mapSize = 48;
        scene.caustics.planes = 7;
        scene.caustics.photonGrid = {40, 40};
        return scene;
    }
    /// Balls side by side at the bottom, some of which a camera does not see.
    static Scene balls() {
        Scene scene = waves({});
        for (int i = 0; i < 9; ++i) {
            const std::string name = "ball" + std::to_string(i);
            scene.receivers.push_back(scenes::shape(name.c_str(), makeSphere(0.15, glm::vec3(0.8f)),
                                                    {0.8 * (i % 3 - 1), -0.7, 0.8 * (i / 3 - 1)}));
        }
        scene.caustics.mapSize = 24;
        scene.water.grid = {48, 48};
        return scene;
    }
    static std::int64_t sumOf(const Skipped& skipped) {
        std::int64_t sum = 0;
        for (const auto& [kind, count] : skipped.byKind())
            sum += count;
        return sum;
    }
    static Picture draw(const Scene& scene, bool skip, Skipped& skipped) {
        Engine engine(context());
        engine.setSkipping(skip);
        engine.set(scene);
        Picture picture = engine.render(0.2, {48, 32});
        skipped = engine.skipped();
        return picture;
    }
};

void expectSameMaps(const Baked& a, const Baked& b, const std::string& what) {
    ASSERT_EQ(a.maps.size(), b.maps.size()) << what;
    for (std::size_t i = 0; i < a.maps.size(); ++i) {
        EXPECT_EQ(a.maps[i].irradiance, b.maps[i].irradiance) << what << ", map " << i;
        EXPECT_EQ(a.maps[i].position, b.maps[i].position) << what << ", map " << i;
        EXPECT_EQ(a.maps[i].normal, b.maps[i].normal) << what << ", map " << i;
    }
    for (std::size_t i = 0; i < a.flux.size(); ++i)
        for (const auto figure : {&FluxBalance::entering, &FluxBalance::absorbed, &FluxBalance::missed,
                                  &FluxBalance::deposited, &FluxBalance::rejected})
            EXPECT_EQ(a.flux[i].*figure, b.flux[i].*figure) << what << ", light " << i;
}

TEST_F(SkippingGLTest, bakesTheSameBits) {
    Scene sea = waves({scenes::floorAt(-1.2), scenes::model("teapot", -1.1)});
    sea.lights.push_back(scenes::sunAt(110, "set"));
    Scene black = waves({scenes::model("fish", -0.8)});
    black.water.absorption = {0.6, 0.2, 0.1};
    black.lights.push_back(scenes::sunAt(-10, "black"));
    black.lights[1].irradiance = glm::dvec3(0);
    Scene standing = waves({scenes::model("box", -0.7), scenes::model("cross", -1.4)});
    standing.lights[0].type = LightType::Point;
    standing.lights[0].position = {0.6, 1.2, 0.3};
    int number = 0;
    Engine skipping(context()), working(context());
    working.setSkipping(false);
    for (Scene& scene : {std::ref(sea), std::ref(black), std::ref(standing)}) {
        ++number;
        for (const Method method : allMethods())
            for (const Fill fill : allFills()) {
                if (fillOf(method, fill) != fill) continue;
                scene.caustics.method = method;
                scene.caustics.fill = fill;
                const bool audit = method == Method::ExactBeam;
                const Baked less = bake(skipping, scene, audit), all = bake(working, scene, audit);
                expectSameMaps(less, all,
                               std::string(methodName(method)) + ", scene " + std::to_string(number));
                EXPECT_EQ(sumOf(working.skipped()), 0) << "nothing is left out where nothing may be";
                const auto dark = std::int64_t(scene.lights.size()) - 1;
                EXPECT_EQ(skipping.skipped().lights, dark);
                double sum = 0;
                for (const MapData& map : less.maps)
                    sum += map.deposited;
                EXPECT_GT(sum, 0.01);
            }
    }
}

TEST_F(SkippingGLTest, countsWhatItLeavesOut) {
    Scene scene = waves({scenes::floorAt(-1.2), scenes::model("teapot", -1.1)});
    scene.lights.push_back(scenes::sunAt(110, "set"));
    scene.caustics.method = Method::LevelMapSmart;
    Engine engine(context());
    engine.set(scene);
    engine.updateCaustics(0);
    EXPECT_EQ(engine.skipped().lights, 1);
    EXPECT_EQ(engine.skipped().unlitMaps, 2) << "two receivers in one dark light";
    EXPECT_EQ(engine.skipped().unreadPasses, 2) << "plane depths of those";
    EXPECT_EQ(engine.skipped().channels, 4) << "two of three for each of two maps in clear water";
    EXPECT_EQ(engine.skipped().levelMaps, 0);
    int planes = 0;
    for (const MapWork& maps : engine.maps())
        if (maps.plan.light == 0) planes += (maps.level.frame.flat ? 1 : 7) - int(maps.level.planes.size());
    EXPECT_EQ(engine.skipped().planes, planes);
    engine.updateCaustics(1); // the waves move, receivers and lights do not
    EXPECT_EQ(engine.skipped().levelMaps, 4);
    EXPECT_EQ(engine.skipped().causticMaps, 0);
    engine.updateCaustics(1);
    EXPECT_EQ(engine.skipped().levelMaps, 4);
    EXPECT_EQ(engine.skipped().causticMaps, 4);
    engine.updateCaustics(2);
    EXPECT_EQ(engine.skipped().causticMaps, 0) << "counts are those of one frame";
}

TEST_F(SkippingGLTest, passesOverBeamsThatMissAReceiver) {
    for (const Method method : {Method::LevelMap, Method::ExactBeam}) {
        Scene scene = balls();
        scene.caustics.method = method;
        scene.lights.push_back(scenes::sunAt(-50, "low"));
        Light pointLight;
        pointLight.name = "lamp";
        pointLight.type = LightType::Point;
        pointLight.position = {0.5, 0.7, 0.1};
        scene.lights.push_back(pointLight);
        scene.receivers.push_back(scenes::floorAt(-0.9, 0.5));
        Engine skipping(context()), working(context());
        working.setSkipping(false);
        const Baked less = bake(skipping, scene), all = bake(working, scene);
        expectSameMaps(less, all, "balls");
        const std::int64_t beams = 2 * 48 * 48, pairs = beams * std::int64_t(skipping.maps().size());
        printf("%.1f %% of beams by maps are culled\n",
               100 * double(skipping.skipped().beams) / double(pairs));
        EXPECT_GT(skipping.skipped().beams, pairs / 2) << "ten small receivers in a wide water";
        EXPECT_LT(skipping.skipped().beams, pairs);
        EXPECT_EQ(working.skipped().beams, 0);
        for (int light = 0; light < 3; ++light) {
            EXPECT_LE(skipping.beamsDrawn(light), beams);
            EXPECT_GT(skipping.beamsDrawn(light), beams / 20);
            EXPECT_EQ(working.beamsDrawn(light), beams);
        }
        double sum = 0;
        for (const MapData& map : less.maps)
            sum += map.deposited;
        EXPECT_GT(sum, 0.1);
        skipping.updateCaustics(0);
        EXPECT_EQ(skipping.skipped().beams, 0) << "a resting map asks about none";
    }
}

TEST_F(SkippingGLTest, passesOverAllBeamsWhereNoneArrive) {
    // A ball in the shade of a floor above it.
    Scene scene =
        waves({scenes::floorAt(-0.4, 3), scenes::shape("ball", makeSphere(0.1, glm::vec3(1)), {0, -0.8, 0})});
    scene.caustics.method = Method::LevelMapSmart;
    Engine engine(context());
    const Baked baked = bake(engine, scene);
    EXPECT_EQ(baked.maps.at(1).deposited, 0);
    EXPECT_GT(baked.maps.at(0).deposited, 1);
    EXPECT_EQ(engine.skipped().unlitMaps, 1);
    EXPECT_GE(engine.skipped().beams, 2 * 32 * 32);
}

TEST_F(SkippingGLTest, aReceiverOutOfReachGetsNoPassAndTheSameBits) {
    Scene scene = balls();
    scene.water.center = glm::dvec2(0);
    scene.water.size = glm::dvec2(3);
    scene.receivers[2].translation.x = 9;
    for (const Method method : {Method::ExactBeam, Method::LevelMap, Method::PhotonSplat}) {
        scene.caustics.method = method;
        Engine all(context()), lean(context());
        all.setSkipping(false);
        const Baked expected = bake(all, scene), found = bake(lean, scene);
        expectSameMaps(expected, found, std::string(methodName(method)));
        EXPECT_EQ(lean.skipped().unlitMaps, 1) << methodName(method);
    }
}

TEST_F(SkippingGLTest, drawsTheSamePictures) {
    Scene scene = balls();
    // From above, from close by, from below the water, from the side into the waves, straight down.
    const glm::dvec3 cameras[][2] = {
        {{0, 1.2, 1.2}, {0, -0.6, 0}},        {{0.9, 0.2, 1.1}, {0.8, -0.7, 0.8}},
        {{-0.8, -0.6, 1.6}, {-0.8, -0.7, 0}}, {{0, -0.75, 0.4}, {0.8, -0.7, 0.8}},
        {{2, 0.02, 0}, {-1, -0.2, 0.6}},      {{0.8, 0.9, -0.8}, {0.8, -1, -0.8001}}};
    std::int64_t hidden = 0;
    for (const auto& [position, target] : cameras) {
        scene.camera.position = position;
        scene.camera.target = target;
        Skipped less, none;
        const Picture skipping = draw(scene, true, less), all = draw(scene, false, none);
        EXPECT_EQ(skipping.rgb, all.rgb) << "camera at " << position.x << " " << position.y;
        EXPECT_EQ(sumOf(none), 0);
        printf("camera %zu: %d of 9 maps are out of view\n", std::size_t(&position - &cameras[0][0]) / 2,
               int(less.outOfView));
        EXPECT_LT(less.outOfView, 9);
        hidden += less.outOfView;
        EXPECT_EQ(less.unreadPasses, less.outOfView);
    }
    EXPECT_GT(hidden, 15);
}

TEST_F(SkippingGLTest, aPictureLeavesNothingOutOfALaterBake) {
    Scene scene = balls();
    scene.camera.position = {0.9, 0.2, 1.1};
    scene.camera.target = {0.8, -0.7, 0.8};
    Engine engine(context()), other(context());
    engine.set(scene);
    engine.render(0.5, {48, 32});
    ASSERT_GT(engine.skipped().outOfView, 0);
    engine.updateCaustics(0.5);
    other.set(scene);
    other.updateCaustics(0.5);
    for (std::size_t i = 0; i < engine.maps().size(); ++i)
        EXPECT_EQ(readMaps(engine.maps()[i], engine.origin()).irradiance,
                  readMaps(other.maps()[i], other.origin()).irradiance);
    engine.render(0.5, {48, 32});
    EXPECT_EQ(engine.skipped().causticMaps + engine.skipped().outOfView, 9) << "all rest or are not seen";
}

double meanOf(const Picture& picture) {
    double sum = 0;
    for (const float value : picture.rgb)
        sum += value;
    return sum / double(picture.rgb.size());
}

double differenceOf(const Picture& a, const Picture& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.rgb.size(); ++i)
        sum += std::abs(double(a.rgb[i]) - double(b.rgb[i]));
    return sum / double(a.rgb.size()) / meanOf(b);
}

TEST_F(SkippingGLTest, whatIsSmallOnScreenHasSmallMapsIfAsked) {
    Scene scene = balls();
    scene.caustics.mapSize = 256;
    Engine engine(context());
    engine.set(scene);
    const Picture whole = engine.render(0.2, {96, 64});
    const std::int64_t bytes = context().ledger().total();
    scene.caustics.texelsPerPixel = 2;
    engine.set(scene);
    const Picture lean = engine.render(0.2, {96, 64});
    for (const MapWork& maps : engine.maps()) {
        if (!maps.isDrawn()) continue;
        const int side = std::max(maps.level.frame.size.x, maps.level.frame.size.y);
        EXPECT_LT(side, 256);
        // The whole picture is 96 pixels wide, and no ball is seen from so near that it fills it.
        EXPECT_GE(side, 16);
        EXPECT_LE(side, 2 * 2 * 96);
    }
    EXPECT_LT(context().ledger().total(), bytes / 2);
    const double difference = differenceOf(lean, whole);
    printf("two texels a pixel: the picture is another by %.3f %%\n", 100 * difference);
    EXPECT_LT(difference, 0.01) << "less than one 8-bit step of a bright picture, on average";
    EXPECT_GT(difference, 0);
    // A bake is whole, also after such a picture.
    scene.caustics.texelsPerPixel = 0;
    const Baked expected = bake(scene);
    engine.set(scene);
    engine.updateCaustics(0);
    expectSameMaps(expected, bake(engine, scene), "after a picture");
}

TEST_F(SkippingGLTest, causticsAreMadeAsOftenAsAskedAndWaterMovesOn) {
    Scene scene = balls();
    scene.caustics.refresh = 10;
    Engine engine(context()), atTick(context());
    engine.set(scene);
    engine.render(0.21, {48, 32});
    const Picture later = engine.render(0.27, {48, 32});
    EXPECT_GT(engine.skipped().causticMaps, 0) << "the tenth of a second has not passed";
    atTick.set(scene);
    const Picture tick = atTick.render(0.2, {48, 32});
    for (std::size_t i = 0; i < engine.maps().size(); ++i) {
        if (!engine.maps()[i].isFilled()) continue;
        EXPECT_EQ(readMaps(engine.maps()[i], engine.origin()).irradiance,
                  readMaps(atTick.maps()[i], atTick.origin()).irradiance);
    }
    EXPECT_GT(differenceOf(later, tick), 0) << "the surface moves";
    // Whatever came before it, a picture is the same.
    Engine fresh(context());
    fresh.set(scene);
    EXPECT_EQ(fresh.render(0.27, {48, 32}).rgb, later.rgb);
}

} // namespace
} // namespace limpid
