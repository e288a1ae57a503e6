#include "godrays/PhotonLines.h"

#include <cmath>

#include "engine/EngineFixture.h"
#include "levelmap/MapPlan.h"
#include "reference/Scattering.h"

namespace limpid {
namespace {

constexpr glm::ivec2 pictureSize(48, 40);

/// A camera in a tank of 2 · 2 m and 1.2 m of water, a ball in it, waves over it, a slanting sun.
Scene tank() {
    Scene scene;
    scene.receivers = {scenes::floorAt(-1.2),
                       scenes::shape("ball", makeSphere(0.2, glm::vec3(1)), {0.2, -0.6, 0})};
    scene.lights = {scenes::sunAt(30)};
    scene.water.waves = {scenes::cosine(0.01, 0.4, {1, 0.3})};
    scene.water.center = glm::dvec2(0);
    scene.water.size = glm::dvec2(2);
    scene.water.grid = glm::ivec2(128);
    scene.water.scattering = {0.3, 0.25, 0.2};
    scene.water.absorption = {0.3, 0.1, 0.05};
    scene.water.anisotropy = 0.6;
    scene.caustics.mapSize = 32;
    scene.camera.position = glm::dvec3(-0.1, -0.5, 2.2);
    scene.camera.target = glm::dvec3(0, -0.6, 0);
    scene.ambientRadiance = glm::dvec3(0);
    scene.godrays.method = GodrayMethod::PhotonLines;
    scene.godrays.scale = 1;
    scene.godrays.filterTaps = 0;
    return scene;
}

class PhotonLinesGLTest : public EngineGLTest {
  protected:
    /// What photon lines add to a picture, in double.
    static std::vector<double> added(Scene scene) {
        Engine engine(context());
        engine.setScene(scene);
        const Picture with = engine.render(0, pictureSize);
        scene.godrays.method = GodrayMethod::None;
        engine.setScene(scene);
        const Picture without = engine.render(0, pictureSize);
        std::vector<double> sum;
        for (std::size_t i = 0; i < with.rgb.size(); ++i)
            sum.push_back(double(with.rgb[i]) - double(without.rgb[i]));
        return sum;
    }
};

reference::ScatterImage truthOf(const Scene& scene, std::int64_t photons) {
    const WaterPatch patch = coveringPatch(scene);
    return reference::scatteredLight(reference::scatterView(scene.camera, sceneOrigin(scene), pictureSize),
                                     {scene, 0, sceneOrigin(scene), patch.min(), patch.size, photons, 1, 2});
}

struct Error {
    double nmae, ratio;
};
Error errorOf(const std::vector<double>& image, const reference::ScatterImage& truth) {
    double error = 0, sum = 0, whole = 0;
    for (std::size_t i = 0; i < image.size(); ++i) {
        const double right = truth.radiance[i / 3][int(i % 3)];
        error += std::abs(image[i] - right);
        sum += image[i];
        whole += right;
    }
    return {error / whole, sum / whole};
}

TEST_F(PhotonLinesGLTest, areSingleScatteringAsTheGridGrows) {
    Scene scene = tank();
    scene.receivers.pop_back();
    scene.godrays.lineWidth = 1;
    const reference::ScatterImage truth = truthOf(scene, 200000);
    double before = 1;
    for (const int grid : {10, 40, 120}) {
        scene.godrays.grid = glm::ivec2(grid);
        const Error error = errorOf(added(scene), truth);
        printf("%d² lines: nMAE %.2f %%, sum %.4f (reference by chance %.2f %%)\n", 2 * grid,
               100 * error.nmae, error.ratio, 100 * truth.standardError);
        EXPECT_LT(error.nmae, before);
        EXPECT_NEAR(error.ratio, 1, 0.005);
        before = error.nmae;
    }
    // What is left beside chance: lines are a pixel wide, and depth is decided by a pixel's middle.
    EXPECT_LT(before, truth.standardError + 0.01);
}

TEST_F(PhotonLinesGLTest, leaveTheShadeDark) {
    const Scene scene = tank();
    const reference::ScatterImage truth = truthOf(scene, 200000);
    const Error error = errorOf(added(scene), truth);
    printf("past a ball: nMAE %.2f %%, sum %.4f (reference by chance %.2f %%)\n", 100 * error.nmae,
           error.ratio, 100 * truth.standardError);
    EXPECT_NEAR(error.ratio, 1, 0.01);
    EXPECT_LT(error.nmae, 0.035);
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
    Scene scene = tank();
    scene.water.scattering = glm::dvec3(0);
    Engine engine(context());
    engine.setScene(scene);
    const std::vector<float> with = engine.render(0, pictureSize).rgb;
    for (const auto& [pass, ms] : engine.timers().collect())
        EXPECT_NE(pass, "godrays");
    EXPECT_EQ(context().ledger().byKind().count("godrays"), 0u);
    scene.godrays.method = GodrayMethod::None;
    engine.setScene(scene);
    EXPECT_EQ(engine.render(0, pictureSize).rgb, with);
}

} // namespace
} // namespace limpid
