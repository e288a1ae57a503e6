#include "io/toml/ProfileFile.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/TempFolder.h"

namespace limpid::io {
namespace {

using test::errorOf;
using test::TempFolder;
using testing::ElementsAre;
using testing::HasSubstr;

Profile load(const TempFolder& folder, const std::string& text) {
    return loadProfile(folder.write("daily.toml", text));
}

TEST(ProfileFileTest, hasDefaults) {
    const TempFolder folder;
    const Profile profile = load(folder, "scene = \"a/pool.toml\"");
    EXPECT_EQ(profile.name, "daily");
    EXPECT_THAT(profile.scenes, ElementsAre(folder.path() / "a/pool.toml"));
    EXPECT_TRUE(profile.receivers.empty());
    EXPECT_TRUE(profile.methods.empty());
    EXPECT_TRUE(profile.planes.empty());
    EXPECT_EQ(profile.warmup, 1);
    EXPECT_EQ(profile.frames, 5);
    EXPECT_EQ(profile.reference, 0);
    EXPECT_FALSE(profile.reuse);
    EXPECT_FALSE(profile.baseline);
}

TEST(ProfileFileTest, readsListsRangesAndSingleValues) {
    const TempFolder folder;
    folder.write("models/b.glb", "x");
    folder.write("models/a.glb", "x");
    folder.write("models/notes.md", "x");
    folder.write("my fish.glb", "x");
    const Profile profile = load(folder, R"(
scenes = ["calm.toml", "rough.toml"]
methods = ["level-map", "level-map-smart"]
fills = ["one-pass", "drawn"]
planes = ["3..5", 50]
map_sizes = 512
grids = [[71, 71], [256, 128]]
receivers = ["models", "my fish.glb", { name = "floor", plane = { size = [2, 2] } }]
set = ["water.level=0.5"]
warmup = 0
frames = 3
reference = 1000000
reuse = true
baseline = "level-map"
picture = [64, 32])");
    EXPECT_EQ(profile.scenes.size(), 2u);
    EXPECT_THAT(profile.methods, ElementsAre(Method::LevelMap, Method::LevelMapSmart));
    EXPECT_THAT(profile.fills, ElementsAre(Fill::OnePass, Fill::Drawn));
    EXPECT_THAT(profile.planes, ElementsAre(3, 4, 5, 50));
    EXPECT_THAT(profile.mapSizes, ElementsAre(512));
    EXPECT_THAT(profile.grids, ElementsAre(glm::ivec2(71, 71), glm::ivec2(256, 128)));
    ASSERT_EQ(profile.receivers.size(), 4u);
    EXPECT_EQ(profile.receivers[0].name, "a") << "a folder is read in the order of names";
    EXPECT_EQ(profile.receivers[1].name, "b");
    EXPECT_EQ(profile.receivers[2].name, "my-fish") << "it becomes part of file names";
    EXPECT_TRUE(profile.receivers[2].model);
    EXPECT_EQ(profile.receivers[3].name, "floor");
    EXPECT_FALSE(profile.receivers[3].model);
    EXPECT_EQ(profile.receivers[3].toml, "[ { name = 'floor', plane = { size = [ 2, 2 ] } } ]");
    EXPECT_EQ(profile.settings.at(0).key, "water.level");
    EXPECT_EQ(profile.reference, 1000000);
    EXPECT_TRUE(profile.reuse);
    EXPECT_EQ(profile.baseline, Method::LevelMap);
    EXPECT_EQ(profile.picture, glm::ivec2(64, 32));
}

TEST(ProfileFileTest, namesPlaceExpectedAndFound) {
    const std::string scene = "scene = \"a.toml\"\n";
    const std::pair<std::string, std::string> cases[] = {
        {"frames = 3", "daily.toml:1:1: scene: expected the path of a scene or model, found nothing"},
        {scene + "methods = [\"magic\"]", "daily.toml:2:11: methods: expected methods of level-map, "},
        {scene + "fills = [\"best\"]",
         "daily.toml:2:9: fills: expected fills of drawn, one-pass, found \"best\""},
        {scene + "planes = [3, 0]",
         "daily.toml:2:10: planes: expected whole numbers from 1 to 4096, or ranges"},
        {scene + "planes = \"9..3\"", "found \"9..3\""},
        {scene + "planes = []", "daily.toml:2:10: planes: expected at least one value, found []"},
        {scene + "grids = [64, 64]",
         "expected a list of pairs of whole numbers from 1 to 8192, found [64, 64]"},
        {scene + "receivers = \"none.glb\"", "none.glb: expected a file, found nothing of that name"},
        {scene + "receivers = [{ plane = { size = [1, 1] } }]", "expected tables with a name"},
        {scene + "receivers = [{ name = \"a\" }, { name = \"a\" }]", "found two named \"a\""},
        {scene + "set = \"level\"", "expected texts of the form KEY=VALUE, found \"level\""},
        {scene + "baseline = \"level-map\"",
         "daily.toml:2:12: baseline: expected one of the methods that are run"},
        {scene + "reuse = 1", "daily.toml:2:9: reuse: expected true or false, found 1"},
        {scene + "frames = 0", "daily.toml:2:10: frames: expected a whole number from 1 to 100000, found 0"},
        {scene + "frame = 1", "daily.toml:2:1: frame: unknown key of a profile, did you mean \"frames\"?"},
        {scene + "[thesis]\nseconds = \"t.tsv\"", "t.tsv: expected a file, found nothing of that name"},
    };
    for (const auto& [text, expected] : cases) {
        const TempFolder folder;
        EXPECT_THAT(errorOf(folder, [&, &text = text] { load(folder, text); }), HasSubstr(expected)) << text;
    }
}

TEST(PrintedTableTest, hasAColumnForReceiverAndMethod) {
    const TempFolder folder;
    const PrintedTable table = loadPrintedTable(folder.write(
        "t.tsv", "# source\nplanes\tteapot level-map\tfish volumetric\n3\t0.5\t1e-1\n\n4\t2\t3\n"));
    EXPECT_THAT(table.planes, ElementsAre(3, 4));
    ASSERT_EQ(table.columns.size(), 2u);
    EXPECT_EQ(table.columns[1].receiver, "fish");
    EXPECT_EQ(table.columns[1].method, "volumetric");
    EXPECT_THAT(table.columns[1].values, ElementsAre(0.1, 3));

    const auto error = [&](const char* text) {
        return errorOf(folder, [&] { loadPrintedTable(folder.write("bad.tsv", text)); });
    };
    EXPECT_EQ(error("3\t4\n"), "bad.tsv:1: expected the columns' names, planes first, found \"3 4\"");
    EXPECT_EQ(error("planes\tteapot\n"),
              "bad.tsv:1: expected columns named RECEIVER METHOD, found \"planes teapot\"");
    EXPECT_EQ(error("planes\ta b\n3\tx\n"),
              "bad.tsv:2: expected a whole number and 1 numbers, found \"3 x\"");
}

} // namespace
} // namespace limpid::io
