#include "plan/Warnings.h"

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
    EXPECT_THAT(warningsOf(scene),
                ElementsAre(HasSubstr("light.sun.angular_diameter: not used by volumetric"),
                            HasSubstr("light.night: does not enter the water"),
                            HasSubstr("receiver.gull: lies above the water")));
}

TEST(Warnings, passOnWhatAFileDoesNotGiveOnce) {
    Scene scene = quiet();
    Mesh mesh = *scene.receivers[0].mesh;
    mesh.notices = {"fish.glb: animations: not used"};
    scene.receivers[0].mesh = std::make_shared<const Mesh>(mesh);
    scene.receivers.push_back(scene.receivers[0]);
    EXPECT_THAT(warningsOf(scene), ElementsAre("fish.glb: animations: not used"));
}

/// A seabed of 2 km under waves of 2 m: at 512 texels each is 3.9 m wide.
TEST(Warnings, nameTexelsWiderThanTheWaves) {
    Scene scene = quiet();
    scene.receivers = {scenes::shape("seabed", makePlane(glm::dvec2(2000), glm::vec3(1)), {0, -8, 0})};
    scene.water.waves = {scenes::cosine(0.03, 2, {1, 0}), scenes::cosine(0.02, 1.3, {0, 1})};
    scene.water.size = glm::dvec2(50);
    scene.water.grid = {512, 512};
    EXPECT_THAT(warningsOf(scene),
                ElementsAre(HasSubstr(
                    "receiver.seabed: expected texels smaller than the waves (2 m), found 3.91 m")));
    scene.caustics.mapSize = 1024;
    EXPECT_THAT(warningsOf(scene), IsEmpty());
    scene.caustics.mapSize = 512;
    scene.water.waves.clear();
    EXPECT_THAT(warningsOf(scene), IsEmpty()) << "flat water";
}

/// Heights of `bits` bits, or floating point for none.
struct StoredHeights : HeightSource {
    HeightBounds limits{{8, 8}, 1, glm::dvec2(0.1)};
    double steps = 0;
    int frameCount() const override { return 1; }
    std::shared_ptr<const HeightField> frame(int) override { return nullptr; }
    const HeightBounds& bounds() const override { return limits; }
    double step() const override { return steps; }
};

TEST(Warnings, nameTheStepsOfEightBits) {
    Scene scene = quiet();
    Wave& wave = scene.water.waves[0];
    wave.type = WaveType::HeightMap;
    wave.amplitude = 0.008;
    wave.size = glm::dvec2(2.4);
    const auto heights = std::make_shared<StoredHeights>();
    wave.heights = heights;
    EXPECT_THAT(warningsOf(scene), IsEmpty());
    heights->steps = 2.0 / 65535;
    EXPECT_THAT(warningsOf(scene), IsEmpty());
    heights->steps = 2.0 / 255;
    EXPECT_THAT(
        warningsOf(scene),
        ElementsAre(HasSubstr("water.wave.0: expected heights of 16 bits or floating point, found steps of "
                              "6.27e-05 m, which bend light by themselves")));
}

} // namespace
} // namespace limpid
