#include "godrays/ExactShafts.h"

#include "io/SceneFile.h"
#include "reference/GodraysFixture.h"

namespace limpid {
namespace {

class ExactShaftsGLTest : public GodraysGLTest {
  protected:
    static Scene tank() { return GodraysGLTest::tank(GodrayMethod::ExactShafts); }
};

TEST_F(ExactShaftsGLTest, areSingleScatteringAsAllGrows) {
    Scene scene = tank();
    scene.receivers.pop_back();
    const reference::ScatterImage truth = truthOf(scene, 200000);
    double before = 1;
    for (const int fineness : {1, 2, 4}) {
        scene.godrays.grid = glm::ivec2(20 * fineness);
        scene.godrays.planes = 8 * fineness;
        scene.godrays.steps = 24 * fineness;
        const Error error = errorOf(added(scene), truth, "finer and finer");
        EXPECT_LT(error.nmae, before);
        EXPECT_NEAR(error.ratio, 1, 0.01);
        before = error.nmae;
    }
    // Beside chance: the tank's edge, which a cell of a fortieth of a metre blurs.
    EXPECT_LT(before, truth.standardError + 0.01);
}

TEST_F(ExactShaftsGLTest, leaveTheShadeDark) {
    const Scene scene = tank();
    const reference::ScatterImage truth = truthOf(scene, 200000);
    const Error error = errorOf(added(scene), truth, "past a ball");
    EXPECT_NEAR(error.ratio, 1, 0.01);
    EXPECT_LT(error.nmae, 0.035);
}

// The project's own bar, on its tank scene.
TEST_F(ExactShaftsGLTest, areWithinFivePercentOnTheTank) {
    Scene scene = io::loadScene(LIMPID_ROOT "/profiles/scenes/tank.toml");
    scene.godrays = GodraySettings{};
    scene.godrays.method = GodrayMethod::ExactShafts;
    scene.godrays.scale = 1;
    scene.caustics.mapSize = 64;
    const glm::ivec2 size(40);
    const reference::ScatterImage truth = truthOf(scene, 400000, size);
    const Error error = errorOf(added(scene, size), truth, "the tank");
    EXPECT_LT(error.nmae, 0.05);
    EXPECT_NEAR(error.ratio, 1, 0.02);
}

TEST_F(ExactShaftsGLTest, takeALampsLight) {
    Scene scene = tank();
    scene.lights[0].type = LightType::Point;
    scene.lights[0].position = {0.4, 1.5, 0.3};
    scene.lights[0].intensity = glm::dvec3(3, 2, 1);
    const reference::ScatterImage truth = truthOf(scene, 200000);
    const Error error = errorOf(added(scene), truth, "under a lamp");
    EXPECT_NEAR(error.ratio, 1, 0.015);
    EXPECT_LT(error.nmae, 0.035);
}

TEST_F(ExactShaftsGLTest, comeOutTheSameBitForBit) {
    Scene scene = tank();
    Engine engine(context());
    engine.setScene(scene);
    const std::vector<float> first = engine.render(0, pictureSize).rgb;
    EXPECT_EQ(engine.render(0, pictureSize).rgb, first);
    for (const float value : first)
        ASSERT_TRUE(std::isfinite(value));
}

TEST_F(ExactShaftsGLTest, costNothingWhereNothingIsScattered) {
    expectNothingWithoutScattering(GodrayMethod::ExactShafts);
}

} // namespace
} // namespace limpid
