// The water, waves and camera of a model given alone.
#include "io/toml/DefaultScene.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "io/TempFolder.h"
#include "io/toml/SceneParser.h"
#include "plan/FlatWater.h"
#include "plan/Warnings.h"
#include "plan/WaveTerms.h"
#include "scene/MeshBuilder.h"

namespace limpid::io {
namespace {

using test::MeshBuilder;

Scene alone(const Mesh& mesh, const Camera* camera = nullptr) {
    const test::TempFolder folder;
    const auto file = folder.write("model.glb", "the mesh is in the cache");
    Model model{mesh, {}, {}};
    if (camera) model.cameras.push_back(*camera);
    MeshCache meshes{{{std::filesystem::weakly_canonical(file), {}}, std::make_shared<const Mesh>(mesh)}};
    return parseScene(defaultScene(file, model), file, meshes);
}

/// Looks at `target`.
Camera cameraAt(const glm::dvec3& position, const glm::dvec3& target) {
    Camera camera;
    camera.position = position, camera.target = target;
    return camera;
}

MeshBuilder boxOfAMetre() {
    return MeshBuilder().box({-0.5, 0, -0.3}, {0.5, 0.4, 0.3});
}

/// How far below a crest of all cosine waves light comes together, m.
double focus(const Water& water) {
    double curvature = 0;
    for (const Wave& wave : water.waves)
        if (wave.type == WaveType::Cosine)
            curvature += wave.amplitude * std::pow(2 * std::numbers::pi / wave.wavelength, 2);
    return water.ior / ((water.ior - 1) * curvature);
}

TEST(DefaultScene, ABasinIsFilledToBelowItsRim) {
    const Scene scene = alone(MeshBuilder().pool().mesh);
    EXPECT_EQ(scene.receivers.size(), 1u) << "it brings its own floor";
    EXPECT_LT(scene.water.level + highestWave(scene.water), 0);
    EXPECT_GT(scene.water.level, -0.2);
    EXPECT_LT(scene.water.waves[0].wavelength, 0.7) << "several waves fit into it";
}

TEST(DefaultScene, TheAuthorsWaterSurfaceIsTheLevel) {
    const Scene scene = alone(MeshBuilder().pool().sheet({-2, -1}, {2, 1}, -0.4, test::Clear).mesh);
    EXPECT_GT(scene.water.level - highestWave(scene.water), -0.4)
        << "the sheet does not stand out of troughs";
    EXPECT_LT(scene.water.level, -0.3);
}

TEST(DefaultScene, WavesFocusLightOnTheGround) {
    const auto seabed = [](double size) {
        MeshBuilder made;
        made.ground([](double x, double z) { return 0.01 * std::sin(9 * x) * std::cos(7 * z); });
        for (glm::dvec3& p : made.mesh.positions)
            p *= size;
        return made.mesh;
    };
    for (const Mesh& mesh : {MeshBuilder().pool().mesh, boxOfAMetre().mesh, seabed(1000), seabed(0.1)}) {
        const Scene scene = alone(mesh);
        const double depth = scene.water.level - worldBounds(scene.receivers[0]).min.y;
        EXPECT_GT(focus(scene.water), 0.7 * depth);
        EXPECT_LT(focus(scene.water), 1.4 * depth);
    }
}

TEST(DefaultScene, AWideLakeHasWavesThatItsGridShows) {
    MeshBuilder lake;
    lake.ground(
        [](double x, double z) { return 0.03 * (x * x + z * z) - 0.03 * std::exp(-6 * (x * x + z * z)); });
    for (glm::dvec3& p : lake.mesh.positions)
        p *= 1000;
    const Scene scene = alone(lake.mesh);
    EXPECT_EQ(scene.receivers.size(), 1u);
    EXPECT_EQ(sceneWarnings(scene, coveringPatch(scene)), std::vector<std::string>{});
    EXPECT_LT(scene.water.level + highestWave(scene.water), 30) << "the rim";
}

TEST(DefaultScene, ItsOwnCameraStaysOutOfTheWavesOfABasin) {
    const Mesh pool = MeshBuilder().pool().mesh;
    struct Case {
        glm::dvec3 position;
        bool taken;
    };
    for (const Case& c : {Case{{0, 2, 3}, true}, Case{{0, -0.12, 0.5}, false}, Case{{0, -0.01, 1.5}, false},
                          Case{{0, -0.7, 0.5}, true}, Case{{0, -0.7, 3}, false}}) {
        const Camera camera = cameraAt(c.position, {0, -0.65, 0});
        EXPECT_EQ(alone(pool, &camera).camera.position.has_value(), c.taken) << c.position.y;
    }
}

TEST(DefaultScene, TheLevelOverASunkenModelFollowsItsCamera) {
    const Mesh box = boxOfAMetre().mesh;
    for (const double distance : {0.2, 1.0, 4.0})
        for (double y = 0.1; y < 4; y += 0.13) {
            const Camera camera = cameraAt({0, y, distance}, {0, 0.2, 0});
            const Scene scene = alone(box, &camera);
            ASSERT_TRUE(scene.camera.position);
            const double above = y - scene.water.level;
            EXPECT_GT(std::abs(above), 2 * highestWave(scene.water)) << distance << ' ' << y;
            EXPECT_GE(scene.water.level, 0.4 + 0.2) << "the model is under water";
            if (above > 0) {
                EXPECT_GT(std::atan2(above, distance), glm::radians(14.9)) << distance << ' ' << y;
            }
            if (y > 2 && distance < 2) {
                EXPECT_GT(above, 0) << "looks down from far above";
            }
        }
}

} // namespace
} // namespace limpid::io
