// What pictures ask of the driver besides drawing.
#include "engine/EngineFixture.h"
#include "view/ToneMapped.h"

namespace limpid {
namespace {

/// Stands before one of the driver's functions and counts its calls. It has been called before: the first
/// call is what libepoxy looks it up by.
template <auto& Function>
class Calls {
  public:
    Calls() : _true(Function) {
        count() = 0;
        real() = _true;
        stand(_true);
    }
    ~Calls() { Function = _true; }
    Calls(const Calls&) = delete;
    Calls& operator=(const Calls&) = delete;
    /// Since it was last asked.
    int made() { return std::exchange(count(), 0); }

  private:
    template <typename... Arguments>
    static void stand(void (*)(Arguments...)) {
        Function = [](Arguments... arguments) {
            ++count();
            real()(arguments...);
        };
    }
    static int& count() {
        static int calls = 0;
        return calls;
    }
    static auto& real() {
        static std::remove_reference_t<decltype(Function)> pointer = nullptr;
        return pointer;
    }
    std::remove_reference_t<decltype(Function)> _true;
};

class PicturesGLTest : public EngineGLTest {
  protected:
    static Scene pond() {
        Scene scene;
        scene.receivers = {scenes::floorAt(-0.6),
                           scenes::shape("ball", makeSphere(0.3, glm::vec3(0.8f)), {0, -0.1, 0})};
        scene.lights = {scenes::sunAt(30)};
        scene.water.grid = {24, 24};
        scene.water.waves = {scenes::cosine(0.02, 0.5, {1, 0.3})};
        scene.water.waves[0].speed = 0.3;
        scene.water.center = glm::dvec2(0);
        scene.water.size = glm::dvec2(4);
        scene.water.scattering = glm::dvec3(0.1);
        scene.godrays.method = GodrayMethod::ExactShafts;
        scene.caustics.mapSize = 64;
        scene.camera.position = {0.4, 1.1, 1.6};
        scene.camera.target = {0, -0.2, 0};
        return scene;
    }
    static constexpr glm::ivec2 size{48, 32};
};

TEST_F(PicturesGLTest, theSurfaceIsReadOnceForEachMomentAndPlace) {
    Scene scene = pond();
    Engine engine(context());
    engine.set(scene);
    engine.render(0, size);
    engine.waterMesh().positions.read<float>(1);
    Calls<epoxy_glGetNamedBufferSubData> reads;
    engine.render(0.1, size);
    EXPECT_EQ(reads.made(), 0) << "far above the waves";
    scene.camera.position->y = -0.015; // under a crest or over a trough
    engine.set(scene);
    for (int i = 1; i < 4; ++i) {
        const Picture picture = engine.render(0.2 * i, size);
        EXPECT_EQ(reads.made(), 1);
        Engine fresh(context());
        fresh.set(scene);
        EXPECT_EQ(fresh.render(0.2 * i, size).rgb, picture.rgb);
        reads.made();
    }
    engine.render(0.2 * 3, size);
    EXPECT_EQ(reads.made(), 0) << "nothing moved";
    scene.camera.position->x += 0.2;
    engine.set(scene);
    engine.render(0.2 * 3, size);
    EXPECT_EQ(reads.made(), 1);
}

TEST_F(PicturesGLTest, targetsStayForThePictureOfThatSize) {
    const std::int64_t before = context().ledger().total();
    {
        Scene scene = pond();
        Engine engine(context());
        engine.set(scene);
        const Picture first = engine.render(0, size);
        const std::int64_t held = context().ledger().total();
        Calls<epoxy_glCreateTextures> textures;
        Calls<epoxy_glCreateFramebuffers> framebuffers;
        Calls<epoxy_glCreateBuffers> buffers;
        EXPECT_EQ(engine.render(0, size).rgb, first.rgb);
        EXPECT_EQ(textures.made(), 0);
        EXPECT_EQ(framebuffers.made(), 0);
        EXPECT_EQ(buffers.made(), 0);
        context().ledger().resetPeak();
        engine.render(0, size + 1);
        EXPECT_GT(textures.made(), 0);
        EXPECT_LT(context().ledger().peak(), held + held / 5) << "those of the size before went first";
        engine.freePicture();
        EXPECT_LT(context().ledger().total(), held);
        EXPECT_EQ(engine.render(0, size).rgb, first.rgb);
    }
    EXPECT_EQ(context().ledger().total(), before);
}

/// What a picture needs at most, it needs at any time, whatever there was before.
TEST_F(PicturesGLTest, targetsMakeRoomForMaps) {
    Scene scene = pond();
    scene.caustics.mapSize = 256;
    gl::Ledger& ledger = context().ledger();
    const std::int64_t before = ledger.total();
    ledger.resetPeak();
    std::vector<float> expected;
    {
        Engine fresh(context());
        fresh.set(scene);
        expected = fresh.render(0.3, {96, 64}).rgb;
    }
    const std::int64_t needed = ledger.peak() - before;
    {
        Engine engine(context());
        engine.setReuse(false);
        engine.set(scene);
        engine.render(0, {96, 64});
        ledger.resetPeak();
        engine.render(0.1, {96, 64});
        EXPECT_GT(ledger.peak() - before, needed) << "or this tests nothing";
        ledger.setLimit(before + needed);
        engine.freePicture();
        EXPECT_NO_THROW(engine.render(0.2, {96, 64}));
        EXPECT_NO_THROW(EXPECT_EQ(engine.render(0.3, {96, 64}).rgb, expected));
        ledger.setLimit(0);
    }
    EXPECT_EQ(ledger.total(), before);
}

TEST_F(PicturesGLTest, aSketchThatServedGivesItsTargetsToTheNext) {
    Engine engine(context());
    engine.set(pond());
    engine.updateForPictures(0);
    PicturePass::Sketch shown = engine.beginPicture(size, 2);
    engine.drawRows(shown, {0, size.y});
    const auto samples = shown.samples().readFloats(GL_RGBA, 4);
    // A second one beside it leaves it as it is.
    PicturePass::Sketch better = engine.beginPicture(size, 2);
    engine.drawRows(better, {0, size.y / 2});
    EXPECT_EQ(shown.samples().readFloats(GL_RGBA, 4), samples);
    const GLuint target = shown.samples().id();
    shown = engine.beginPicture(size, 2, std::move(shown));
    engine.drawRows(shown, {0, size.y});
    EXPECT_EQ(shown.samples().id(), target);
    EXPECT_EQ(shown.samples().readFloats(GL_RGBA, 4), samples);
    shown = engine.beginPicture(size, 1, std::move(shown));
    EXPECT_EQ(shown.samples().size(), size);
}

TEST_F(PicturesGLTest, pixelsAreTheMeansOfTheirSamplesToTheBit) {
    Engine engine(context());
    engine.set(pond());
    engine.updateForPictures(0);
    const Picture picture = engine.draw(size);
    const PicturePass::Sketch sketch = engine.beginPicture(size, 2, {});
    engine.drawRows(sketch, {0, size.y});
    const auto samples = sketch.samples().readFloats(GL_RGBA, 4);
    std::vector<float> expected(picture.rgb.size());
    for (int y = 0; y < 2 * size.y; ++y)
        for (int x = 0; x < 2 * size.x; ++x)
            for (int c = 0; c < 3; ++c)
                expected[std::size_t(3 * ((size.y - 1 - y / 2) * size.x + x / 2) + c)] +=
                    0.25f * samples[std::size_t(4 * (y * 2 * size.x + x) + c)];
    EXPECT_EQ(picture.rgb, expected);
}

TEST_F(PicturesGLTest, toneMappedByTheShaderIsToneMappedAsTheCpuDoesIt) {
    Scene scene = pond();
    Engine engine(context());
    for (const double exposure : {0.0, 1.5, -3.0}) {
        scene.camera.exposure = exposure;
        engine.set(scene);
        const auto expected = toneMapped(engine.render(0, size), exposure);
        const auto shown = engine.renderToneMapped(0, size);
        ASSERT_EQ(shown.size(), expected.size());
        int differ = 0;
        for (std::size_t i = 0; i < shown.size(); ++i) {
            EXPECT_NEAR(shown[i], expected[i], 1);
            differ += shown[i] != expected[i];
        }
        EXPECT_LT(differ, int(shown.size() / 200)); // pow() by the driver, next to a step
    }
}

} // namespace
} // namespace limpid
