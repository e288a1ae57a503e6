#include "engine/Warnings.h"

#include <gmock/gmock.h>

#include "engine/Scenes.h"

namespace limpid {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::vector<std::string> warningsOf(const Scene& scene) {
    return sceneWarnings(scene, coveringPatch(scene));
}

Scene quiet() {
    Scene scene;
    scene.receivers = {scenes::floorAt(-1)};
    scene.lights = {scenes::sunAt(30)};
    scene.water.waves = {scenes::cosine(0.004, 0.3, {1, 0})};
    return scene;
}

TEST(Warnings, areNoneForAnOrdinaryScene) {
    EXPECT_THAT(warningsOf(quiet()), IsEmpty());
}

TEST(Warnings, nameWavesTooShortForTheGrid) {
    Scene scene = quiet();
    scene.water.grid = {8, 8};
    EXPECT_THAT(warningsOf(scene),
                ElementsAre(HasSubstr("water.wave.0: expected waves of at least two quads")));
}

TEST(Warnings, nameWavesThatBeamsCrossAgain) {
    Scene scene = quiet();
    scene.water.waves[0].amplitude = 0.06;
    EXPECT_THAT(warningsOf(scene),
                ElementsAre(HasSubstr("water.wave: expected slopes below 1, found up to 1.26")));
}

TEST(Warnings, nameWhatTakesNoPart) {
    Scene scene = quiet();
    scene.receivers.push_back(scenes::shape("gull", makeSphere(0.1, glm::vec3(1)), {0, 2, 0}));
    scene.lights.push_back(scenes::sunAt(95, "night"));
    scene.lights[0].angularDiameter = 0.53;
    scene.caustics.method = Method::Volumetric;
    EXPECT_THAT(warningsOf(scene), ElementsAre(HasSubstr("light.sun.angular_diameter: not used by volumetric"),
                                               HasSubstr("light.night: does not enter the water"),
                                               HasSubstr("receiver.gull: lies above the water")));
}

} // namespace
} // namespace limpid
