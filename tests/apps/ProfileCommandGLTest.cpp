#include <fstream>
#include <sstream>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "apps/RunProgram.h"
#include "io/TempFolder.h"
#include "io/images/Images.h"

namespace limpid {
namespace {

using test::Result;
using test::run;
using ::testing::HasSubstr;
using Json = nlohmann::json;

constexpr const char* scene = R"(
[water]
level = 1.2
[[water.wave]]
amplitude = 0.01
speed = 0.2
[[light]]
name = "sun"
[[receiver]]
name = "ball"
sphere = { radius = 0.5 }
translation = [0, 0.5, 0]
)";

// exact-beam has no planes to draw.
constexpr const char* profile = R"(
scene = "scene.toml"
methods = ["level-map", "level-map-smart", "exact-beam"]
baseline = "level-map"
planes = [3, 9]
map_sizes = [16, 24]
grids = [[8, 8]]
frames = 2
picture = [8, 8]
[thesis]
seconds = "thesis.tsv"
)";

class ProfileCommandGLTest : public testing::Test {
  protected:
    ProfileCommandGLTest() {
        folder.write("scene.toml", scene);
        folder.write("tiny.toml", profile);
        folder.write("thesis.tsv", "planes\tball level-map\n3\t0.1\n9\t0.2\n");
    }
    std::string path(const std::string& name) const { return (folder.path() / name).string(); }
    Json results() const { return Json::parse(std::ifstream(path("out/results.json"))); }
    test::TempFolder folder;
};

void expectSpread(const Json& spread) {
    EXPECT_GT(spread["min"], 0);
    EXPECT_LE(spread["min"], spread["median"]);
    EXPECT_LE(spread["median"], spread["p95"]);
}

void expectSane(const Json& result) {
    expectSpread(result["wall_ms"]);
    expectSpread(result["caustics_ms"]);
    EXPECT_GE(result["wall_ms"]["min"], result["caustics_ms"]["min"]) << "the frame holds its caustics";
    for (const char* pass : {"water", "beams", "level map", "caustic map", "picture"})
        EXPECT_TRUE(result["gpu_ms"].contains(pass)) << pass;
    std::int64_t bytes = 0;
    for (const auto& [kind, size] : result["gpu_bytes"].items())
        if (kind != "total" && kind != "peak") bytes += size.get<std::int64_t>();
    EXPECT_EQ(result["gpu_bytes"]["total"], bytes);
    EXPECT_GE(result["gpu_bytes"]["peak"], result["gpu_bytes"]["position map"]);
    EXPECT_EQ(result["beams_drawn"], 2 * 8 * 8);
    EXPECT_EQ(result["maps"][0]["size"][0], result["map_size"]);
    if (result["method"] == "exact-beam")
        EXPECT_EQ(result["planes_drawn"], 0);
    else
        EXPECT_EQ(result["planes_drawn"].get<int>() + result["skipped"]["planes"].get<int>(),
                  result["planes"].get<int>() * int(result["maps"].size()));
}

TEST_F(ProfileCommandGLTest, aRunThatIsStoppedLeavesWhatItMeasured) {
    const std::string all =
        fmt::format("profile {} -o {} --quiet --frames 100000", path("tiny.toml"), path("out"));
    // Seconds of them go into shaders, which no cache has yet.
    const std::string command = fmt::format("timeout 20 {}/limpid {} 2>&1", test::buildFolder(), all);
    EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 124);
    const Json kept = results();
    // How many of the twelve it came to is the machine's affair.
    EXPECT_GE(kept["results"].size(), 1u);
    for (const Json& result : kept["results"])
        EXPECT_GT(result["caustics_ms"]["min"], 0);
}

TEST_F(ProfileCommandGLTest, measuresEveryCombination) {
    const Result ran = run("profile " + path("tiny.toml") + " -o " + path("out"));
    ASSERT_EQ(ran.code, 0) << ran.out;
    const Json json = results();
    for (const char* key : {"limpid", "commit", "build", "date"})
        EXPECT_FALSE(json[key].get<std::string>().empty()) << key;
    EXPECT_GE(json["machine"]["cores"], 1);
    EXPECT_EQ(json["machine"]["gl"].get<std::string>().substr(0, 2), "4.");
    ASSERT_EQ(json["results"].size(), 12u);
    std::set<std::string> combinations;
    for (const Json& result : json["results"]) {
        expectSane(result);
        EXPECT_EQ(result["receiver"], "ball");
        combinations.insert(result["method"].dump() + result["planes"].dump() + result["map_size"].dump());
        const bool smart = result["method"] == "level-map-smart";
        EXPECT_EQ(result.contains("difference"), result["method"] != "level-map");
        if (!smart) continue;
        EXPECT_EQ(result["difference"]["largest"], 0) << "smart slicing leaves out work only";
        EXPECT_EQ(result["difference"]["luv"], 0);
        EXPECT_GT(result["skipped"]["planes"], 0) << "nothing lights a ball from below";
    }
    EXPECT_EQ(combinations.size(), 12u);
    ASSERT_EQ(json["depth_histograms"].size(), 1u);
    EXPECT_EQ(json["depth_histograms"][0]["texels"].size(), 9u) << "of the most planes";
    EXPECT_THAT(ran.out, HasSubstr("level-map-smart"));

    std::ifstream csv(path("out/results.csv"));
    std::size_t lines = 0, columns = 0;
    for (std::string line; std::getline(csv, line); ++lines) {
        const auto commas = std::size_t(std::count(line.begin(), line.end(), ','));
        if (lines == 0) columns = commas;
        EXPECT_EQ(commas, columns) << line;
    }
    EXPECT_EQ(lines, 13u);
    for (const char* plot : {"depth-histogram", "time-planes", "memory-planes", "planes-drawn"}) {
        const std::string file = path(std::string("out/tiny.") + plot);
        EXPECT_GT(io::readImage(file + ".png").width, 100) << plot;
        EXPECT_TRUE(std::filesystem::exists(file + ".svg")) << plot;
    }
}

#ifdef LIMPID_WITH_REFERENCE
// Under flat water the light is known: E (1 - F) on each face by its slope, and nothing is to be traced
// finely.
TEST_F(ProfileCommandGLTest, isJudgedByGroundTruthThatItKeeps) {
    folder.write("judged.toml", R"(
scene = "scene.toml"
methods = ["level-map", "level-map-smart", "exact-beam"]
set = ["water.wave=[]", "water.grid=[16, 16]"]
planes = 3
map_sizes = 24
frames = 1
picture = [8, 8]
reference = 20000)");
    const std::string command = "profile --quiet " + path("judged.toml") + " -o " + path("out");
    const Result ran = run(command);
    ASSERT_EQ(ran.code, 0) << ran.out;
    const Json first = results()["results"];
    for (const Json& result : first) {
        // All of it but the ball's rim, where a texel sees the ball in part: a ring of 2π texels of radius
        // 12 among 144π, of which a method may lose or double every one.
        EXPECT_LT(result["error"]["nmae"], 2.0 / 12) << result["method"];
        EXPECT_GE(result["error"]["standard_error"], 0);
    }
    EXPECT_EQ(first[0]["error"], first[1]["error"]) << "smart slicing leaves out work only";
    const auto kept = std::filesystem::directory_iterator(path("out/references"))->path();
    const auto written = std::filesystem::last_write_time(kept / "index.json");
    ASSERT_EQ(run(command).code, 0);
    EXPECT_EQ(std::filesystem::last_write_time(kept / "index.json"), written) << "traced once";
    EXPECT_EQ(results()["results"][2]["error"], first[2]["error"]);
}

constexpr const char* godrayProfile = R"(
scene = "scene.toml"
set = ["water.level=2", "camera.position=[0, 0.6, 2]", "camera.target=[0, 0.6, 0]", "water.scattering=[0.2, 0.2, 0.2]",
       "water.grid=[32, 32]", "water.center=[0, 0]", "water.size=[12, 12]", "water.wave.0.amplitude=0",
       "caustics.map_size=32"]
frames = 1
picture = [12, 8]
reference = 400000
[[godrays]]
method = "photon-lines"
scale = 1
filter_taps = 0
[[godrays]]
method = "exact-shafts"
scale = 1
filter_taps = 0
[[godrays]]
method = "tetrahedra"
grid = [40, 40]
scale = 1
filter_taps = 0
)";

TEST_F(ProfileCommandGLTest, measuresGodraysAgainstSingleScattering) {
    folder.write("rays.toml", godrayProfile);
    const Result ran = run("profile " + path("rays.toml") + " -o " + path("out"));
    ASSERT_EQ(ran.code, 0) << ran.out;
    EXPECT_THAT(ran.out, AllOf(HasSubstr("exact-shafts"), HasSubstr("tetrahedra")));
    const Json rays = results()["godrays"];
    ASSERT_EQ(rays.size(), 3u);
    for (const Json& result : rays) {
        expectSpread(result["godrays_ms"]);
        EXPECT_GT(result["gpu_bytes"], 0);
        EXPECT_NEAR(result["error"]["flux_ratio"], 1, 0.05);
        EXPECT_GT(result["error"]["standard_error"], 0);
        EXPECT_LT(result["error"]["nmae"].get<double>(),
                  result["error"]["standard_error"].get<double>() + 0.1);
    }
    EXPECT_TRUE(results()["results"].empty());
    EXPECT_TRUE(std::filesystem::exists(path("out/godrays.csv")));
}
#endif

TEST_F(ProfileCommandGLTest, doesWithoutGnuplotAndTakesModels) {
    const Result ran = run("profile " + path("tiny.toml") + " -o " + path("out") + " --frames 1 --receiver " +
                               test::rootFolder() + "/models/box.glb",
                           "PATH=/nonexistent");
    ASSERT_EQ(ran.code, 0) << ran.out;
    EXPECT_THAT(ran.out, HasSubstr("limpid: warning: expected gnuplot to draw plots with, found none"));
    EXPECT_EQ(results()["results"][0]["receiver"], "box");
    EXPECT_FALSE(std::filesystem::exists(path("out/tiny.time-planes.png")));
}

TEST_F(ProfileCommandGLTest, reusesOnlyWhereTheProfileLetsIt) {
    folder.write("reuse.toml", R"(
scene = "scene.toml"
set = ["caustics.map_size=16", "water.grid=[8, 8]"]
reuse = true
frames = 1
picture = [8, 8])");
    const Result ran = run("profile --quiet " + path("reuse.toml") + " -o " + path("out"));
    ASSERT_EQ(ran.code, 0) << ran.out;
    EXPECT_EQ(ran.out, "");
    const Json passes = results()["results"][0]["gpu_ms"];
    EXPECT_TRUE(passes.contains("caustic map")) << "the water moved";
    EXPECT_FALSE(passes.contains("level map")) << "the ball did not";
}

TEST_F(ProfileCommandGLTest, saysInOneLineWhatIsWrong) {
    folder.write("magic.toml", "scene = \"scene.toml\"\nmethods = [\"magic\"]\n");
    folder.write("lost.toml", "scene = \"lost-scene.toml\"\n");
    folder.write("dry.toml", "scene = \"scene.toml\"\n[[godrays]]\nmethod = \"exact-shafts\"\n");
    folder.write("flat.toml", "scene = \"scene.toml\"\ngodrays = [\"exact-shafts\"]\n");
    const std::string out = " -o " + path("out");
    const std::pair<std::string, std::string> cases[] = {
        {"profile " + path("magic.toml") + out, "magic.toml:2:11: methods: expected methods of level-map, "},
        {"profile " + path("lost.toml") + out,
         "lost-scene.toml: expected a file, found nothing of that name"},
        {"profile " + path("dry.toml") + out, "godrays: expected a camera under the water, found none"},
        {"profile " + path("flat.toml") + out,
         "flat.toml:2:11: godrays: expected tables as a scene has them"},
        {"profile " + path("tiny.toml"), "--output is required"},
        {"profile " + path("tiny.toml") + " -o " + path("scene.toml"), "expected a folder to write to"},
        {"profile " + path("tiny.toml") + " " + path("tiny.toml") + out, "found two named \"tiny\""},
        {"profile " + path("tiny.toml") + out + " --frames 0", "--frames"},
    };
    for (const auto& [arguments, expected] : cases) {
        const Result result = run(arguments);
        EXPECT_EQ(result.code, 2) << arguments;
        EXPECT_THAT(result.out, HasSubstr(expected)) << arguments;
        EXPECT_EQ(std::count(result.out.begin(), result.out.end(), '\n'), 1) << result.out;
    }
}

} // namespace
} // namespace limpid
