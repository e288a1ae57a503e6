#include "godrays/ExactShafts.h"

#include "Folders.h"
#include "io/toml/SceneFile.h"
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
    expectShadeIsDark(tank());
}

// The project's own bar, on its tank scene.
TEST_F(ExactShaftsGLTest, areWithinFivePercentOnTheTank) {
    Scene scene = io::loadScene(test::rootFolder() + "/profiles/scenes/tank.toml");
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
    expectLampsLight(tank());
}

TEST_F(ExactShaftsGLTest, comeOutTheSameBitForBit) {
    expectTheSameBits(tank());
}

TEST_F(ExactShaftsGLTest, costNothingWhereNothingIsScattered) {
    expectNothingWithoutScattering(GodrayMethod::ExactShafts);
}

} // namespace
} // namespace limpid
