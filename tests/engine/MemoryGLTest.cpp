// Too little memory on the GPU, at every allocation of a frame in turn: an error each time, and the same
// engine then makes what a fresh one would, to the bit.
#include <algorithm>

#include <gmock/gmock.h>

#include "core/Error.h"
#include "engine/EngineFixture.h"
#include "scene/Sea.h"

namespace limpid {
namespace {

/// Stands before the driver's own glGetError, and says "out of memory" once, when asked for the nth time.
/// Only allocations ask.
class FailingDriver {
  public:
    explicit FailingDriver(int nth) : _true(epoxy_glGetError) {
        left() = nth;
        real() = _true;
        epoxy_glGetError = [] { return --left() == 0 ? GLenum(GL_OUT_OF_MEMORY) : real()(); };
    }
    ~FailingDriver() { epoxy_glGetError = _true; }
    FailingDriver(const FailingDriver&) = delete;
    FailingDriver& operator=(const FailingDriver&) = delete;

    static bool failed() { return left() <= 0; }

  private:
    static int& left() {
        static int count = 0;
        return count;
    }
    static PFNGLGETERRORPROC& real() {
        static PFNGLGETERRORPROC pointer = nullptr;
        return pointer;
    }
    PFNGLGETERRORPROC _true;
};

class MemoryGLTest : public EngineGLTest {
  protected:
    void TearDown() override {
        context().ledger().setLimit(0);
        EngineGLTest::TearDown();
    }

    static Scene pool(Method method) {
        Scene scene;
        scene.receivers = {scenes::floorAt(-1),
                           scenes::shape("ball", makeSphere(0.3, glm::vec3(0.8f)), {0, -0.5, 0})};
        scene.lights = {scenes::sunAt(30)};
        scene.water.waves = {scenes::cosine(0.01, 0.3, {1, 0.4})};
        scene.water.grid = {8, 8};
        scene.caustics.mapSize = 16;
        scene.caustics.planes = 3;
        scene.caustics.photonGrid = {8, 8};
        scene.caustics.method = method;
        return scene;
    }
    /// With godrays, which only a camera under water sees.
    static Scene murky(GodrayMethod method) {
        Scene scene = pool(Method::ExactBeam);
        scene.water.scattering = glm::dvec3(0.1);
        scene.camera.position = glm::dvec3(0, -0.3, 1.5);
        scene.camera.target = glm::dvec3(0, -0.5, 0);
        scene.godrays.method = method;
        scene.godrays.grid = {4, 4};
        scene.godrays.planes = 2;
        scene.godrays.steps = 4;
        return scene;
    }
    /// A sea, and a sun with a disc.
    static Scene windy() {
        Scene scene = pool(Method::ExactBeam);
        scene.lights[0].angularDiameter = 2;
        Wave sea;
        sea.amplitude = 0.01;
        Wind wind;
        wind.modes = 4;
        EXPECT_TRUE(raiseSea(sea, wind));
        scene.water.waves.push_back(sea);
        return scene;
    }
    /// With shadow maps of 16 and 24 MiB beside what else takes less than 2.
    static Scene shadows() {
        Scene scene = pool(Method::ExactBeam);
        scene.receivers.push_back(
            scenes::shape("post", makeBox({0.1, 1, 0.1}, glm::vec3(0.8f)), {0.5, -0.2, 0}));
        Light pointLight;
        pointLight.name = "lamp";
        pointLight.type = LightType::Point;
        pointLight.position = {0.2, -0.3, 0.1};
        scene.lights.push_back(pointLight);
        return scene;
    }
    static std::vector<Scene> scenes() {
        std::vector<Scene> all;
        for (const Method method : allMethods())
            all.push_back(pool(method));
        all.push_back(pool(Method::LevelMap));
        all.back().caustics.fill = Fill::Drawn;
        all.push_back(windy());
        all.push_back(murky(GodrayMethod::ExactShafts));
        all.push_back(murky(GodrayMethod::PhotonLines));
        return all;
    }

    struct Frame {
        std::vector<float> irradiance, picture;
        bool operator==(const Frame&) const = default;
    };
    static Frame frame(Engine& engine) {
        engine.updateCaustics(1);
        Frame frame;
        for (const MapWork& maps : engine.maps()) {
            const MapData data = readMaps(maps, engine.origin());
            frame.irradiance.insert(frame.irradiance.end(), data.irradiance.begin(), data.irradiance.end());
        }
        frame.picture = engine.draw({16, 9}).rgb;
        return frame;
    }
    /// Whether the nth allocation of a frame was one that could fail.
    static bool runsOut(Engine& engine, const Scene& scene, int nth) {
        const FailingDriver driver(nth);
        try {
            engine.set(scene);
            frame(engine);
        } catch (const GraphicsError& error) {
            EXPECT_THAT(error.what(), testing::HasSubstr("bytes on the GPU, found out of memory"));
            return true;
        }
        EXPECT_FALSE(FailingDriver::failed());
        return false;
    }
    static Frame freshFrame(const Scene& scene) {
        Engine engine(context());
        engine.set(scene);
        return frame(engine);
    }
};

/// Before each failure the engine has had a scene of other sizes, so that it has to ask for all memory again.
TEST_F(MemoryGLTest, afterAnyAllocationThatFailedAnEngineDrawsAsAFreshOne) {
    Scene other = pool(Method::Stencil);
    other.water.grid = {4, 4};
    other.caustics.mapSize = 8;
    other.caustics.planes = 2;
    const std::int64_t before = context().ledger().total();
    for (const Scene& scene : scenes()) {
        SCOPED_TRACE(methodName(scene.caustics.method));
        const Frame expected = freshFrame(scene);
        Engine engine(context());
        int allocations = 0;
        for (bool failed = true; failed; ++allocations) {
            SCOPED_TRACE(allocations);
            engine.set(other);
            engine.updateCaustics(0);
            failed = runsOut(engine, scene, allocations + 1);
            if (engine.scene().water.grid == other.water.grid) engine.set(scene);
            ASSERT_TRUE(frame(engine) == expected);
        }
        EXPECT_GT(allocations, 40);
    }
    EXPECT_EQ(context().ledger().total(), before);
}

/// By the budget of --gpu-memory, and with no other scene in between.
TEST_F(MemoryGLTest, withMoreRoomAnEngineDrawsAsAFreshOne) {
    const Scene scene = shadows();
    gl::Ledger& ledger = context().ledger();
    ledger.resetPeak();
    const std::int64_t before = ledger.total();
    const Frame expected = freshFrame(scene);
    const std::int64_t needed = ledger.peak() - before;
    const Frame expectedSmaller = freshFrame(pool(Method::LevelMapSmart));
    ASSERT_EQ(ledger.total(), before);
    for (const std::int64_t room : {std::int64_t(1), std::int64_t(60'000), std::int64_t(14'000'000),
                                    std::int64_t(30'000'000), needed - 1}) {
        SCOPED_TRACE(room);
        Engine engine(context());
        ledger.setLimit(before + room);
        EXPECT_THROW((engine.set(scene), frame(engine)), GraphicsError);
        EXPECT_LE(ledger.total(), before + room);
        ledger.setLimit(before + needed);
        if (engine.scene().receivers.empty()) engine.set(scene);
        EXPECT_TRUE(frame(engine) == expected);
        ledger.setLimit(before + room);
        EXPECT_THROW((engine.set(Scene()), engine.set(scene), frame(engine)), GraphicsError);
        ledger.setLimit(before + std::max<std::int64_t>(room, 4'000'000));
        engine.set(pool(Method::LevelMapSmart));
        EXPECT_TRUE(frame(engine) == expectedSmaller);
    }
}

} // namespace
} // namespace limpid
