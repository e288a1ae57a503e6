#include <filesystem>
#include <fstream>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "apps/RunProgram.h"
#include "io/TempFolder.h"
#include "io/images/Images.h"
#include "scene/Scene.h"

namespace limpid {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

using test::Result;
using test::run;

std::string models(const char* name) {
    return test::rootFolder() + "/models/" + name;
}
const std::string quick = " --set water.grid=[32,32] --map-size 64 --planes 5";

class CommandLineGLTest : public testing::Test {
  protected:
    test::TempFolder folder;
    std::string path(const char* name) const { return (folder.path() / name).string(); }
    std::size_t files() const {
        return std::size_t(std::distance(std::filesystem::directory_iterator(folder.path()), {}));
    }
};

TEST_F(CommandLineGLTest, aBareModelGivesAPicture) {
    const Result result =
        run("render " + models("fish.glb") + " -o " + path("fish.png") + " --size 96x54" + quick);
    EXPECT_EQ(result.code, 0) << result.out;
    const io::FloatImage picture = io::readImage(path("fish.png"));
    EXPECT_EQ(picture.width, 96);
    EXPECT_EQ(picture.height, 54);
    EXPECT_GT(*std::max_element(picture.data.begin(), picture.data.end()), 0.5f);
    EXPECT_EQ(files(), 1u) << "and no partial file";
}

TEST_F(CommandLineGLTest, exrIsLinear) {
    const Result result =
        run("render " + models("box.glb") + " -o " + path("a.exr") + " --size 32x18 --quiet" + quick);
    EXPECT_EQ(result.code, 0);
    EXPECT_EQ(result.out, "") << "--quiet";
    EXPECT_EQ(io::readImage(path("a.exr")).channels, 3);
}

TEST_F(CommandLineGLTest, everyMethodBakesUnderItsName) {
    for (const Method method : allMethods()) {
        const std::string name(methodName(method));
        EXPECT_THAT(run("bake --help").out, HasSubstr(name));
        const Result result =
            run("bake " + models("sphere.glb") + " -o " + path("maps") + " --method " + name + quick);
        ASSERT_EQ(result.code, 0) << result.out;
        const auto index = nlohmann::json::parse(std::ifstream(path("maps/index.json")));
        EXPECT_EQ(index["method"], name);
        EXPECT_GT(index["maps"][0]["flux"]["deposited"], 0);
    }
    const Result unknown = run("bake " + models("sphere.glb") + " -o " + path("none") + " --method mirror");
    EXPECT_EQ(unknown.code, 2);
    for (const Method method : allMethods())
        EXPECT_THAT(unknown.out, HasSubstr(fmt::format("\"{}\"", methodName(method))));
}

TEST_F(CommandLineGLTest, bakeWithoutAuditHasTheSameMaps) {
    const std::string scene = "bake " + models("sphere.glb") + quick;
    ASSERT_EQ(run(scene + " -o " + path("counted")).code, 0);
    ASSERT_EQ(run(scene + " --no-audit -o " + path("plain")).code, 0);
    const auto counted = nlohmann::json::parse(std::ifstream(path("counted/index.json")));
    const auto plain = nlohmann::json::parse(std::ifstream(path("plain/index.json")));
    EXPECT_EQ(plain["maps"], counted["maps"]);
    EXPECT_GT(plain["maps"][0]["flux"]["deposited"], 0);
    EXPECT_FALSE(plain["lights"][0].contains("flux"));
    EXPECT_EQ(run("compare " + path("plain") + " " + path("counted") + " --max-nmae 0").code, 0);
}

TEST_F(CommandLineGLTest, bakeWritesTheContract) {
    const Result result = run("bake " + models("sphere.glb") + " -o " + path("maps") + quick);
    ASSERT_EQ(result.code, 0) << result.out;
    const auto index = nlohmann::json::parse(std::ifstream(path("maps/index.json")));
    EXPECT_EQ(index["method"], "exact-beam");
    EXPECT_EQ(index["lights"][0]["light"], "sun");
    EXPECT_EQ(index["lights"][0]["beams"], 2 * 32 * 32);
#ifdef LIMPID_WITH_REFERENCE
    const auto& flux = index["lights"][0]["flux"];
    double rest = flux["entering"];
    for (const char* part : {"absorbed", "scattered", "deposited", "missed", "rejected", "residual"})
        rest -= double(flux[part]);
    EXPECT_NEAR(rest, 0, 1e-9);
    EXPECT_GE(flux["standard_error"], 0);
    EXPECT_LE(flux["standard_error"], 0.001 * double(flux["entering"]));
#endif
    ASSERT_EQ(index["maps"].size(), 2u);
    for (const auto& map : index["maps"]) {
        EXPECT_LE(map["planes"]["drawn"], map["planes"]["requested"]);
        const auto irradiance = io::readImage(folder.path() / "maps" / std::string(map["irradiance"]));
        const auto position = io::readImage(folder.path() / "maps" / std::string(map["position"]));
        EXPECT_EQ(irradiance.width, map["size"][0]);
        EXPECT_EQ(irradiance.channelNames, (std::vector<std::string>{"R", "G", "B"}));
        EXPECT_EQ(position.channelNames, (std::vector<std::string>{"R", "G", "B", "A"}));
        const auto m = map["world_to_texture"].get<std::vector<double>>();
        for (int y = 0; y < position.height; y += 7)
            for (int x = 0; x < position.width; x += 7) {
                const float* p = &position.data[4 * std::size_t(y * position.width + x)];
                if (p[3] == 0) continue;
                const double u = m[0] * p[0] + m[4] * p[1] + m[8] * p[2] + m[12];
                const double v = m[1] * p[0] + m[5] * p[1] + m[9] * p[2] + m[13];
                EXPECT_NEAR(u * position.width, x + 0.5, 0.01);
                EXPECT_NEAR(v * position.height, y + 0.5, 0.01);
            }
    }
}

#ifdef LIMPID_WITH_REFERENCE
TEST_F(CommandLineGLTest, referenceWritesTheMapsOfBake) {
    const Result baked = run("bake " + models("box.glb") + " -o " + path("maps") + quick);
    ASSERT_EQ(baked.code, 0) << baked.out;
    const std::string command = "reference " + models("box.glb") + " --photons 20000 --quiet" + quick;
    const Result traced = run(command + " -o " + path("truth"));
    ASSERT_EQ(traced.code, 0) << traced.out;
    EXPECT_EQ(traced.out, "") << "--quiet";
    const auto bake = nlohmann::json::parse(std::ifstream(path("maps/index.json")));
    const auto truth = nlohmann::json::parse(std::ifstream(path("truth/index.json")));
    EXPECT_EQ(truth["method"], "reference");
    EXPECT_GE(truth["lights"][0]["beams"], 20000);
    ASSERT_EQ(truth["maps"].size(), bake["maps"].size());
    for (std::size_t i = 0; i < bake["maps"].size(); ++i) {
        const auto &a = bake["maps"][i], &b = truth["maps"][i];
        EXPECT_GT(b["standard_error"], 0);
        for (const char* key :
             {"receiver", "light", "size", "irradiance", "position", "normal", "world_to_texture"})
            EXPECT_EQ(a[key], b[key]);
        const auto p = io::readImage(folder.path() / "maps" / std::string(a["position"]));
        const auto q = io::readImage(folder.path() / "truth" / std::string(b["position"]));
        int differing = 0;
        for (std::size_t k = 0; k < p.data.size(); k += 4) {
            if (p.data[k + 3] != q.data[k + 3]) ++differing;
            if (p.data[k + 3] != 1 || q.data[k + 3] != 1) continue;
            // A float holds 1e-7 of a depth of a metre; the rasteriser's grid is 1/256 of a texel.
            for (std::size_t c = 0; c < 3; ++c)
                EXPECT_NEAR(p.data[k + c], q.data[k + c], 1e-3);
        }
        EXPECT_LE(differing, 8) << "texels whose middle lies on an edge";
    }
    EXPECT_EQ(run(command + " --threads 1 -o " + path("again")).code, 0);
    EXPECT_EQ(truth, nlohmann::json::parse(std::ifstream(path("again/index.json"))));
}
#endif

TEST_F(CommandLineGLTest, wrongUsageIsTwo) {
    const std::string fish = models("fish.glb"), out = " -o " + path("x.png");
    const std::pair<std::string, std::string> cases[] = {
        {"", "Usage: limpid"},
        {"paint", "expected a command (render, view, bake, compare, profile, info"},
        {"render " + fish + out + " --colour 5", "found \"--colour 5\""},
        {"render " + fish + out + " --metod stencil",
         "found \"--metod stencil\", did you mean \"--method\"?"},
        {"render " + fish + out + " --map_size=64", "did you mean \"--map-size\"?"},
        {"render " + fish + out + " --planes 0", "expected a whole number from 1 to 4096, found 0"},
        {"bake " + fish + " -o " + path("x") + " --time nan", "--time"},
        {"render " + fish + out + " --size 7680x10", "--size: expected at most"},
        {"render " + fish, "limpid: --output is required"},
        {"render " + fish + " -o " + path("x.jpg"),
         "expected a name that ends in .png or .exr, found \".jpg\""},
        {"render " + fish + " -o " + path("no/x.png"), "expected a folder to write to, found none named"},
        {"render none.glb" + out, "limpid: none.glb: expected a file, found nothing of that name"},
        {"render " + fish + out + " --size 0x5",
         "--size: expected WxH with 1 to 7680 pixels each, found \"0x5\""},
        {"render " + fish + out + " --set novalue", "--set: expected KEY=VALUE, found \"novalue\""},
        {"render " + fish + out + " --method magic", "--set caustics.method=magic: expected"},
        {"render " + fish + out + " --planes -3",
         "--set caustics.planes=-3: expected a whole number from 1 to 4096, found -3"},
        {"bake " + fish + " -o " + fish, "expected a folder to write to, found"},
#ifdef LIMPID_WITH_REFERENCE
        {"reference " + fish + " -o " + path("x") + " --photons 0", "--photons: "},
        {"reference " + fish + " -o " + fish, "expected a folder to write to, found"},
#endif
    };
    for (const auto& [arguments, expected] : cases) {
        const Result result = run(arguments);
        EXPECT_EQ(result.code, 2) << arguments;
        EXPECT_THAT(result.out, HasSubstr(expected)) << arguments;
        if (!arguments.empty()) {
            EXPECT_EQ(std::count(result.out.begin(), result.out.end(), '\n'), 1) << result.out;
        }
    }
    EXPECT_EQ(files(), 0u) << "nothing half-written";
}

TEST_F(CommandLineGLTest, aMissingGraphicsSystemIsThree) {
    const Result none = run("info", "__EGL_VENDOR_LIBRARY_FILENAMES=/nonexistent");
    EXPECT_EQ(none.code, 3);
    EXPECT_THAT(none.out, StartsWith("limpid: EGL: expected a device with OpenGL 4.5 core, found none"));
    const Result device = run("info --device 99");
    EXPECT_EQ(device.code, 3);
    EXPECT_THAT(device.out, StartsWith("limpid: EGL: expected a device named or numbered \"99\""));
}

TEST_F(CommandLineGLTest, helpAndVersionAreZero) {
    EXPECT_EQ(run("--help").code, 0);
    EXPECT_EQ(run("render --help").code, 0);
    EXPECT_THAT(run("--version").out, StartsWith("limpid 0."));
    const Result info = run("info --json");
    EXPECT_EQ(info.code, 0);
    EXPECT_TRUE(nlohmann::json::parse(info.out).contains("renderer"));
}

} // namespace
} // namespace limpid
