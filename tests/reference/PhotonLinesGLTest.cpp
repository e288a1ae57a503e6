#include "godrays/PhotonLines.h"

#include "reference/GodraysFixture.h"

namespace limpid {
namespace {

class PhotonLinesGLTest : public GodraysGLTest {
  protected:
    static Scene tank() { return GodraysGLTest::tank(GodrayMethod::PhotonLines); }
};

TEST_F(PhotonLinesGLTest, areSingleScatteringAsTheGridGrows) {
    Scene scene = tank();
    scene.receivers.pop_back();
    scene.godrays.lineWidth = 1;
    const reference::ScatterImage truth = truthOf(scene, 200000);
    double before = 1;
    for (const int grid : {10, 40, 120}) {
        scene.godrays.grid = glm::ivec2(grid);
        const Error error = errorOf(added(scene), truth, "twice as many lines along a side");
        EXPECT_LT(error.nmae, before);
        EXPECT_NEAR(error.ratio, 1, 0.005);
        before = error.nmae;
    }
    // What is left beside chance: lines are a pixel wide, and depth is decided by a pixel's middle.
    EXPECT_LT(before, truth.standardError + 0.01);
}

TEST_F(PhotonLinesGLTest, leaveTheShadeDark) {
    expectShadeIsDark(tank());
}

TEST_F(PhotonLinesGLTest, areAsBrightAtAnyWidthAndScale) {
    Scene scene = tank();
    const auto sum = [&] {
        double whole = 0;
        for (const double value : added(scene))
            whole += value;
        return whole;
    };
    scene.godrays.lineWidth = 1;
    const double thin = sum();
    // What is spread past the picture's edge comes in from there too, but for the tank's own edge: of 12 of
    // 48 pixels a few percent.
    scene.godrays.lineWidth = 12;
    EXPECT_NEAR(sum(), thin, 0.03 * thin);
    scene.godrays.scale = 0.4;
    scene.godrays.lineWidth = 2;
    EXPECT_NEAR(sum(), thin, 0.03 * thin);
    scene.godrays.filterTaps = 8;
    EXPECT_NEAR(sum(), thin, 0.03 * thin);
    // Schlick's phase function stands in for the other within some percent at these angles.
    scene.godrays.phase = Phase::Schlick;
    EXPECT_NEAR(sum(), thin, 0.3 * thin);
}

TEST_F(PhotonLinesGLTest, costNothingWhereNothingIsScattered) {
    expectNothingWithoutScattering(GodrayMethod::PhotonLines);
}

} // namespace
} // namespace limpid
