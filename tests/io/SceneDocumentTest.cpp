// A changed scene, written and read again, is the changed scene; what did not change stays as its author
// wrote it.
#include "io/toml/SceneDocument.h"
#include "Folders.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/SmallGltf.h"
#include "io/TempFolder.h"
#include "io/toml/SceneSettings.h"
#include "scene/Sea.h"
#include "scene/WaterBodies.h"
#include "scene/WaterPresets.h"

namespace limpid::io {
namespace {

using test::TempFolder;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* pool = R"(# Grüße: a pool, "quoted" # twice
[water]                 # the water
absorption = [0.3, 0.1, 0.05] # red goes first
grid = [64, 64]

[[water.wave]]
amplitude = 0.01        # m
wavelength = 0.5

[[light]]
name = "sun"
direction = [0.3, -1, 0.1] # from the left

[[receiver]] # what caustics fall on
name = "floor"
plane = { size = [2, 2] }
translation = [0, -1, 0]
)";

/// Saves `changed` in the document's folder, or in `folder`, and reads it again.
Scene again(const SceneDocument& document, const Scene& changed, const TempFolder& folder,
            std::string* text = nullptr) {
    const std::string saved = document.textOf(changed, folder.path());
    if (text) *text = saved;
    return loadScene(folder.write("again.toml", saved));
}

void expectSame(const Scene& a, const Scene& b) {
    const auto one = settingsOf(a), two = settingsOf(b);
    ASSERT_EQ(one.size(), two.size());
    for (std::size_t i = 0; i < one.size(); ++i)
        EXPECT_EQ(one[i].value, two[i].value) << one[i].section << ' ' << one[i].key;
}

TEST(SceneDocument, withoutAChangeTheTextIsTheSame) {
    const TempFolder folder;
    const SceneDocument document(folder.write("pool.toml", pool));
    EXPECT_EQ(document.textOf(document.scene(), folder.path()), pool);
}

TEST(SceneDocument, changesJustWhatChanged) {
    const TempFolder folder;
    const SceneDocument document(folder.write("pool.toml", pool));
    Scene changed = document.scene();
    changed.water.absorption = {0.1, 0.2, 1.0 / 3};
    changed.water.waves[0].amplitude = 0.0125;
    changed.water.waves[0].phase = 30;
    changed.lights[0].direction = {1, -2, 0.5};
    changed.camera.position = {1, 2, 3};
    changed.camera.target = {0, -1, 1e-7};
    changed.caustics.method = Method::LevelMap;
    changed.receivers[0].scale = {1, 2, 1};
    std::string text;
    expectSame(again(document, changed, folder, &text), changed);
    for (const char* kept :
         {"# Grüße: a pool, \"quoted\" # twice\n[water]                 # the water\n",
          "absorption = [0.1, 0.2, 0.3333333333333333] # red goes first\n",
          "amplitude = 0.0125        # m\nwavelength = 0.5\n", "grid = [64, 64]\n",
          "direction = [1, -2, 0.5] # from the left\n", "[[receiver]] # what caustics fall on\n"})
        EXPECT_THAT(text, HasSubstr(kept));
}

TEST(SceneDocument, wavesComeAndGo) {
    const TempFolder folder;
    const SceneDocument document(folder.write("pool.toml", pool));
    Scene changed = document.scene();
    changed.water.waves = presetWaves(2, {0, 0});
    std::string text;
    expectSame(again(document, changed, folder, &text), changed);
    EXPECT_THAT(text, HasSubstr("# from the left"));
    changed.water.waves.clear();
    expectSame(again(document, changed, folder, &text), changed);
    EXPECT_THAT(text, Not(HasSubstr("wave")));
}

TEST(SceneDocument, aSeaStaysWhatItsFileSays) {
    const TempFolder folder;
    const SceneDocument document(folder.write("sea.toml",
                                              "[[water.wave]]\ntype = \"phillips\"\namplitude = 0.02\n"
                                              "wind = [2, 1] # from the west\nmodes = 16\n"
                                              "[[receiver]]\nsphere = { radius = 1 }\n"));
    const auto expectSea = [](const Scene& scene, double amplitude) {
        const Wave& wave = scene.water.waves.front();
        EXPECT_EQ(wave.type, WaveType::Phillips);
        EXPECT_EQ(wave.amplitude, amplitude);
        EXPECT_EQ(wave.spectrum->modes, 16);
    };
    Scene changed = document.scene();
    changed.water.waves[0].amplitude = 0.03;
    std::string text;
    expectSea(again(document, changed, folder, &text), 0.03);
    EXPECT_THAT(text, HasSubstr("wind = [2, 1] # from the west\n"));
    // Beside a wave that is new, the sea is written again.
    changed.water.waves.emplace_back();
    const Scene two = again(document, changed, folder);
    ASSERT_EQ(two.water.waves.size(), 2u);
    expectSea(two, 0.03);
    EXPECT_EQ(two.water.waves[1].type, WaveType::Cosine);
}

TEST(SceneDocument, aPresetThatIsChangedBecomesWaves) {
    const TempFolder folder;
    const SceneDocument document(folder.write(
        "preset.toml", "[water]\npreset = \"breeze\"\nlevel = 1 # m\n[[receiver]]\nsphere = { radius = 1 }"));
    Scene changed = document.scene();
    expectSame(again(document, changed, folder), changed);
    changed.water.waves[1].amplitude *= 2;
    std::string text;
    expectSame(again(document, changed, folder, &text), changed);
    EXPECT_THAT(text, HasSubstr("level = 1 # m"));
    EXPECT_THAT(text, Not(HasSubstr("preset")));
}

/// A pond whose `[water]` and `[[water.wave]]` are as given.
SceneDocument pondOf(const TempFolder& folder, const std::string& water) {
    return SceneDocument(folder.write("pond.toml", water + "\n[[receiver]]\nsphere = { radius = 1 }\n"));
}

TEST(SceneDocument, aSeasWindIsWritten) {
    const TempFolder folder;
    const SceneDocument document =
        pondOf(folder, "[[water.wave]]\ntype = \"phillips\" # a sea\nsize = 2\nmodes = 16\nshortest = 0.5");
    Scene changed = document.scene();
    ASSERT_TRUE(raiseSea(changed.water.waves[0],
                         {.velocity = {1, 2.5}, .tile = {3, 2}, .modes = 8, .seed = 4000000000u}));
    std::string text;
    const Scene read = again(document, changed, folder, &text);
    expectSame(read, changed);
    EXPECT_EQ(read.water.waves[0].spectrum->amplitudes, changed.water.waves[0].spectrum->amplitudes);
    EXPECT_THAT(text, HasSubstr("type = \"phillips\" # a sea\n"));
    EXPECT_THAT(text, Not(HasSubstr("shortest"))); // as the tile and the modes have it again
    // And a wave of another kind becomes one.
    const SceneDocument plain(folder.write("pool.toml", pool));
    changed = plain.scene();
    ASSERT_TRUE(raiseSea(changed.water.waves[0], {.shortest = 0.7}));
    expectSame(again(plain, changed, folder, &text), changed);
    EXPECT_THAT(text, HasSubstr("shortest = 0.7"));
}

TEST(SceneDocument, wavesThatWereScaledAreWrittenAsTheyAre) {
    const TempFolder folder;
    for (const char* water : {"[water]\nwave_scale = 0.3 # lower\n[[water.wave]] # kept\nwavelength = 0.5",
                              "[water]\nwave_scale = 0.3 # lower\npreset = \"rain drops\""}) {
        const SceneDocument document = pondOf(folder, water);
        std::string text;
        Scene changed = document.scene();
        changed.water.level = 0.5;
        expectSame(again(document, changed, folder, &text), changed);
        EXPECT_THAT(text, HasSubstr("wave_scale = 0.3 # lower"));
        changed.water.center = {1, 2}; // which rain would follow
        expectSame(again(document, changed, folder), changed);
        changed.water.waves[0].amplitude = 0.007;
        expectSame(again(document, changed, folder, &text), changed);
        EXPECT_THAT(text, Not(HasSubstr("wave_scale")));
    }
}

TEST(SceneDocument, aPresetIsWrittenByItsName) {
    const TempFolder folder;
    const SceneDocument document(folder.write("pool.toml", pool));
    Scene changed = document.scene();
    changed.water.center = {1, -1};
    for (std::size_t preset = 0; preset < std::size(waterPresets); ++preset) {
        changed.water.waves = presetWaves(preset, {1, -1});
        std::string text;
        expectSame(again(document, changed, folder, &text), changed);
        EXPECT_THAT(text, HasSubstr("preset = \"" + std::string(waterPresets[preset]) + '"'));
        EXPECT_THAT(text, Not(HasSubstr("[[water.wave]]")));
    }
}

TEST(SceneDocument, namedWaterComesAndGoes) {
    const TempFolder folder;
    const SceneDocument named = pondOf(folder, "[water]\ntype = \"pool\" # tiled\nlevel = 1");
    Scene changed = named.scene();
    std::string text;
    setWaterBody(3, changed.water);
    expectSame(again(named, changed, folder, &text), changed);
    EXPECT_THAT(text, HasSubstr("type = \"coastal\" # tiled"));
    changed.water.scattering.x = 0.5;
    expectSame(again(named, changed, folder, &text), changed);
    EXPECT_THAT(text, Not(HasSubstr("type")));
    // Back to water that takes nothing, anisotropy included.
    changed.water = Water{};
    changed.water.level = 1;
    expectSame(again(named, changed, folder), changed);

    const SceneDocument pool3(folder.write("pool.toml", pool));
    changed = pool3.scene();
    setWaterBody(2, changed.water);
    expectSame(again(pool3, changed, folder, &text), changed);
    EXPECT_THAT(text, Not(HasSubstr("absorption")));
}

TEST(SceneDocument, whatIsLeftToTheEngineAgainIsTakenOut) {
    const TempFolder folder;
    for (const char* water : {"[water]\ncenter = [1, 2]\nsize = [\n  3, # wide\n  4]\nlevel = 1 # m",
                              "water = { center = [1, 2], size = [3, 4], level = 1 }"}) {
        const SceneDocument document = pondOf(folder, water);
        Scene changed = document.scene();
        changed.water.center.reset();
        changed.water.size.reset();
        changed.water.ior = 1.4; // goes to where the first line went
        const Scene read = again(document, changed, folder);
        expectSame(read, changed);
        EXPECT_EQ(read.water.level, 1);
    }
}

TEST(SceneDocument, splatsAndGodraysAreWritten) {
    const TempFolder folder;
    const SceneDocument document(folder.write("pool.toml", pool));
    Scene changed = document.scene();
    changed.caustics.method = Method::PhotonSplat;
    changed.caustics.texelsPerPixel = 1.5;
    changed.caustics.refresh = 30;
    changed.caustics.photonGrid = {30, 40};
    changed.caustics.photonGridOver = PhotonGridOver::Water;
    changed.caustics.photonSubdivision = 3;
    changed.caustics.splatSize = {4, 9.5};
    changed.caustics.filterTaps = 0;
    changed.caustics.filterRadius = 1.25;
    changed.godrays = {.method = GodrayMethod::PhotonLines,
                       .phase = Phase::Schlick,
                       .grid = {50, 60},
                       .subdivision = 1,
                       .scale = 0.5,
                       .lineWidth = 2,
                       .filterTaps = 4,
                       .filterRadius = 3};
    const Scene read = again(document, changed, folder);
    EXPECT_EQ(read.caustics, changed.caustics);
    EXPECT_EQ(read.godrays, changed.godrays);
}

TEST(SceneDocument, tablesOfOneLineAreWrittenAnew) {
    const TempFolder folder;
    const SceneDocument document(
        folder.write("inline.toml", "camera = { exposure = 1 }\nreceiver = [{ sphere = { radius = 1 } }]\n"));
    Scene changed = document.scene();
    changed.camera.position = {1, 2, 3};
    changed.camera.exposure = 0.25;
    changed.receivers[0].translation.y = -3;
    changed.receivers[0].rotation = glm::angleAxis(0.3, glm::normalize(glm::dvec3(1, 2, 3)));
    const Scene read = again(document, changed, folder);
    EXPECT_EQ(read.camera, changed.camera);
    EXPECT_EQ(read.receivers[0].translation, changed.receivers[0].translation);
    // Reading normalises the turn once more.
    EXPECT_NEAR(glm::dot(read.receivers[0].rotation, changed.receivers[0].rotation), 1, 1e-15);
}

TEST(SceneDocument, aModelAloneBecomesAScene) {
    const TempFolder folder;
    const SceneDocument document(std::filesystem::path(test::rootFolder()) / "models/sphere.glb",
                                 {{"water.level", "2"}});
    Scene changed = document.scene();
    changed.camera.position = {1, 3, 3};
    changed.camera.target = {0, 0, 0};
    changed.lights[0].irradiance = {1, 2, 3};
    const Scene read = again(document, changed, folder);
    expectSame(read, changed);
    EXPECT_EQ(read.receivers[0].mesh->positions, changed.receivers[0].mesh->positions);
    EXPECT_EQ(read.receivers[0].name, changed.receivers[0].name);
}

TEST(SceneDocument, whatIsLeftOutOfAModelStaysOut) {
    const TempFolder folder;
    test::SmallGltf gltf = test::triangleGltf();
    gltf.addMesh({{"attributes", {{"POSITION", 0}}}});
    gltf.json["nodes"][1]["name"] = "Wat\"er*";
    const SceneDocument document(folder.write("pool.glb", gltf.glb()), {leavingOut({R"(Wat"er\*)"})});
    EXPECT_EQ(document.scene().receivers[0].mesh->triangleCount(), 1u);
    Scene changed = document.scene();
    changed.receivers[0].translation.y = 1;
    const Scene read = again(document, changed, folder);
    EXPECT_EQ(read.receivers[0].mesh->triangleCount(), 1u);
    EXPECT_EQ(read.receivers[0].translation.y, 1);
}

TEST(SceneDocument, filesAreFoundFromElsewhere) {
    const TempFolder folder, elsewhere;
    std::filesystem::copy(std::filesystem::path(test::rootFolder()) / "models/sphere.glb",
                          folder.path() / "ball.glb");
    const SceneDocument document(folder.write("scene.toml", "[[receiver]] # here\ngltf = \"ball.glb\"\n"));
    std::string text;
    const Scene read = again(document, document.scene(), elsewhere, &text);
    EXPECT_EQ(read.receivers[0].mesh->positions, document.scene().receivers[0].mesh->positions);
    EXPECT_THAT(text, HasSubstr("# here"));
    EXPECT_THAT(document.textOf(document.scene(), folder.path()), HasSubstr("gltf = \"ball.glb\""));
}

} // namespace
} // namespace limpid::io
