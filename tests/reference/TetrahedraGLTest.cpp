#include "godrays/Tetrahedra.h"

#include <numeric>

#include "Folders.h"
#include "io/toml/SceneFile.h"
#include "reference/GodraysFixture.h"
#include "reference/Refraction.h"

namespace limpid {
namespace {

double sumOf(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0);
}

class TetrahedraGLTest : public GodraysGLTest {
  protected:
    static Scene tank() { return GodraysGLTest::tank(GodrayMethod::Tetrahedra); }

    /// Water without an end, flat, a camera in the midst of what is lit.
    static Scene openWater(double degrees) {
        Scene scene = tank();
        scene.water.waves.clear();
        scene.lights = {scenes::sunAt(degrees)};
        scene.receivers = {scenes::shape("speck", makeSphere(0.01, glm::vec3(1)), {50, -50, 50})};
        scene.camera.position = glm::dvec3(0, -0.6, 0.8);
        scene.camera.target = glm::dvec3(0.1, -0.7, 0);
        scene.godrays.grid = glm::ivec2(3);
        return scene;
    }

    /// The closed form along the view ray through the middle of a pixel: the sun goes one way everywhere, and
    /// reaches what it enters above.
    static glm::dvec3 radianceAlong(const Scene& scene, const glm::dvec3& view) {
        const Water& water = scene.water;
        const glm::dvec3 incident = glm::normalize(scene.lights[0].direction);
        const glm::dvec3 light = reference::refracted(incident, {0, 1, 0}, water.ior);
        const glm::dvec3 eye = *scene.camera.position, lost = water.absorption + water.scattering;
        // Where the ray is lit: the entry above moves evenly along it.
        const glm::dvec3 entry = eye - eye.y / light.y * light, step = view - view.y / light.y * light;
        double from = 0, to = view.y > 0 ? -eye.y / view.y : 1e9;
        for (const int axis : {0, 2}) {
            const double a = (-1 - entry[axis]) / step[axis], b = (1 - entry[axis]) / step[axis];
            from = std::max(from, std::min(a, b)), to = std::min(to, std::max(a, b));
        }
        if (from >= to) return glm::dvec3(0);
        // e^-c(path + t), path = (eye.y + t view.y) / light.y.
        const glm::dvec3 rate = lost * (view.y / light.y + 1), at = glm::exp(-lost * (eye.y / light.y));
        const glm::dvec3 along = (glm::exp(-rate * from) - glm::exp(-rate * to)) / rate;
        const double flux = reference::transmitted(-incident.y, water.ior) * incident.y / light.y;
        return water.scattering * scene.lights[0].irradiance * flux *
               reference::phase(-glm::dot(view, light), water.anisotropy) * at * along;
    }
};

TEST_F(TetrahedraGLTest, areTheClosedFormUnderFlatWater) {
    for (const double degrees : {0.0, 40.0})
        for (const int subVolumes : {0, 192}) {
            Scene scene = openWater(degrees);
            scene.godrays.subVolumes = subVolumes;
            const std::vector<double> image = added(scene);
            const reference::ScatterView view =
                reference::scatterView(scene.camera, sceneOrigin(scene), pictureSize);
            const double focus = 0.5 * pictureSize.y / std::tan(0.5 * glm::radians(scene.camera.verticalFov));
            double error = 0, sum = 0, whole = 0;
            for (std::size_t i = 0; i < image.size() / 3; ++i) {
                const glm::dvec2 at = (glm::dvec2(int(i) % pictureSize.x, int(i) / pictureSize.x) + 0.5 -
                                       0.5 * glm::dvec2(pictureSize)) /
                                      focus;
                const glm::dvec3 truth =
                    radianceAlong(scene, glm::normalize(view.forward + at.x * view.right - at.y * view.up));
                for (int c = 0; c < 3; ++c) {
                    error += std::abs(image[3 * i + c] - truth[c]);
                    sum += image[3 * i + c], whole += truth[c];
                }
            }
            printf("sun at %.0f degrees, %d sub-volumes: nMAE %.3f %%, sum %.5f\n", degrees, subVolumes,
                   100 * error / whole, sum / whole);
            // What straight lines make of the loss: by its setting half a percent in the darkest channel, and
            // by the square of their number less; here that asks for 89 of them. And what lies before the
            // near plane, a thousandth of the way to the target.
            const double most = 0.001 + 0.005 * (subVolumes == 0 ? 1.0 : 89.0 * 89 / (192 * 192));
            EXPECT_LT(error / whole, most);
            EXPECT_NEAR(sum / whole, 1, most);
        }
}

TEST_F(TetrahedraGLTest, areSingleScatteringAsTheGridGrows) {
    Scene scene = tank();
    scene.receivers.pop_back();
    const reference::ScatterImage truth = truthOf(scene, 200000);
    double before = 1;
    for (const int grid : {5, 10, 25}) {
        scene.godrays.grid = glm::ivec2(grid);
        const Error error = errorOf(added(scene), truth, "more and more volumes");
        EXPECT_LT(error.nmae, before);
        before = error.nmae;
    }
    EXPECT_LT(before, truth.standardError + 0.01);
}

TEST_F(TetrahedraGLTest, leaveTheShadeDark) {
    Scene scene = tank();
    scene.godrays.grid = glm::ivec2(25);
    expectShadeIsDark(scene);
}

// The project's own bar, on its tank scene.
TEST_F(TetrahedraGLTest, areWithinFivePercentOnTheTank) {
    Scene scene = io::loadScene(test::rootFolder() + "/profiles/scenes/tank.toml");
    scene.godrays = GodraySettings{};
    scene.godrays.method = GodrayMethod::Tetrahedra;
    scene.godrays.scale = 1;
    scene.godrays.grid = glm::ivec2(25);
    scene.caustics.mapSize = 64;
    const glm::ivec2 size(64);
    const reference::ScatterImage truth = truthOf(scene, 400000, size);
    const Error error = errorOf(added(scene, size), truth, "the tank");
    EXPECT_LT(error.nmae, 0.05);
    EXPECT_NEAR(error.ratio, 1, 0.02);
}

TEST_F(TetrahedraGLTest, loseNothingWhereLightFolds) {
    Scene scene = tank();
    scene.receivers.pop_back();
    // Slopes up to 0.8: light comes to a focus 0.2 m below the crests, and is folded all the way from there.
    scene.water.waves = {scenes::cosine(0.02, 0.2, {1, 0.3}), scenes::cosine(0.01, 0.3, {-0.4, 1})};
    scene.godrays.grid = glm::ivec2(25);
    const reference::ScatterImage truth = truthOf(scene, 200000);
    const Error error = errorOf(added(scene), truth, "folded");
    EXPECT_NEAR(error.ratio, 1, 0.01);
}

TEST_F(TetrahedraGLTest, endWhereLightAndViewEnd) {
    Scene scene = openWater(0);
    const double open = sumOf(added(scene));
    scene.receivers = {scenes::shape("wall", makeBox({2, 2, 0.02}, glm::vec3(1)), {0, -1.01, 0.5})};
    const double walled = sumOf(added(scene));
    EXPECT_GT(walled, 0);
    EXPECT_LT(walled, 0.6 * open);
    // The 9 cm over the lid are hidden by it.
    scene.receivers = {scenes::shape("lid", makeBox({4, 0.02, 4}, glm::vec3(1)), {0, -0.1, 0})};
    EXPECT_EQ(sumOf(added(scene)), 0);
}

TEST_F(TetrahedraGLTest, takeALampsLight) {
    Scene scene = tank();
    scene.godrays.grid = glm::ivec2(25);
    expectLampsLight(scene);
}

TEST_F(TetrahedraGLTest, comeOutTheSameBitForBit) {
    Scene scene = tank();
    scene.godrays.grid = glm::ivec2(20);
    expectTheSameBits(scene);
}

TEST_F(TetrahedraGLTest, costNothingWhereNothingIsScattered) {
    expectNothingWithoutScattering(GodrayMethod::Tetrahedra);
}

} // namespace
} // namespace limpid
