#include <filesystem>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "apps/RunProgram.h"
#include "io/TempFolder.h"
#include "io/bake/BakedFolder.h"
#include "io/images/Images.h"

namespace limpid {
namespace {

using test::Result;
using test::run;
using ::testing::HasSubstr;
using ::testing::Not;

class CompareCommandTest : public testing::Test {
  protected:
    test::TempFolder folder;
    std::string path(const std::string& name) const { return (folder.path() / name).string(); }

    /// Two grey pixels, linear.
    void picture(const std::string& name, float left, float right) const {
        io::writeExr(path(name), 2, 1, {"R", "G", "B"},
                     std::vector<float>{left, left, left, right, right, right});
    }
    /// A baked folder with one map of two texels, as large as they are high.
    void bake(const std::string& name, float left, float right, const char* receiver = "floor") const {
        io::BakedMap map;
        map.receiver = receiver;
        map.light = "sun";
        map.size = {2, 1};
        map.irradiance = {left, left, left, right, right, right};
        map.position = {0, 0, 0, 1, 0, 0, 0, 1};
        map.normal = {0, 0, 1, 0, 0, 1};
        map.standardError = 0.001;
        io::Bake bake;
        bake.maps = {map};
        io::writeBake(path(name), bake);
    }
    Result compare(const std::string& a, const std::string& b, const std::string& more = "") const {
        return run("compare " + path(a) + " " + path(b) + " " + more);
    }
};

TEST_F(CompareCommandTest, linksInACircleAreAnErrorOfOneLine) {
    std::filesystem::create_symlink(path("b"), path("a"));
    std::filesystem::create_symlink(path("a"), path("b"));
    const Result result = compare("a", "b");
    EXPECT_EQ(result.code, 2);
    EXPECT_EQ(result.out, "limpid: " + path("a") +
                              ": expected a name that leads to a file or folder, found Too many levels of "
                              "symbolic links\n");
}

TEST_F(CompareCommandTest, printsEveryFigure) {
    picture("a.exr", 1, 4);
    picture("b.exr", 1, 3);
    const Result table = compare("a.exr", "b.exr");
    EXPECT_EQ(table.code, 0);
    for (const char* figure : {"nMAE", "nRMSE", "relMSE", "PSNR", "Luv", "flux ratio", "largest"})
        EXPECT_THAT(table.out, HasSubstr(figure));
    EXPECT_THAT(table.out, HasSubstr("1 at 1,0"));
    const auto json = nlohmann::json::parse(compare("a.exr", "b.exr", "--json").out);
    const auto& item = json["compared"][0];
    EXPECT_EQ(item["pixels"], 2);
    EXPECT_EQ(item["error"]["nmae"], 0.25);
    EXPECT_EQ(item["error"]["flux_ratio"], 1.25);
    EXPECT_EQ(item["error"]["largest"]["at"], (std::vector<int>{1, 0}));
}

TEST_F(CompareCommandTest, failsBeyondALimitAndSaysWhich) {
    picture("a.exr", 1, 4);
    picture("b.exr", 1, 3);
    EXPECT_EQ(compare("a.exr", "b.exr", "--max-nmae 0.25 --max-error 1 --max-flux 0.25").code, 0);
    const Result result = compare("a.exr", "b.exr", "--max-nmae 0.2 --max-error 1 --min-psnr 60 --quiet");
    EXPECT_EQ(result.code, 1);
    EXPECT_EQ(result.out, "limpid: picture: nMAE 0.25 is beyond --max-nmae 0.2\n"
                          "limpid: picture: PSNR 12.5527 is beyond --min-psnr 60\n");
    EXPECT_EQ(compare("b.exr", "b.exr", "--min-psnr 1000 --max-luv 0 --max-relmse 0").code, 0);
}

TEST_F(CompareCommandTest, neverPassesWhatIsNotFinite) {
    picture("a.exr", std::numeric_limits<float>::quiet_NaN(), 3);
    picture("b.exr", 1, 3);
    const Result free = compare("a.exr", "b.exr");
    EXPECT_EQ(free.code, 0);
    EXPECT_THAT(free.out, HasSubstr("pixels left out, not finite: 1 of A, 0 of B"));
    const Result limited = compare("a.exr", "b.exr", "--max-nmae 1 --quiet");
    EXPECT_EQ(limited.code, 1);
    EXPECT_EQ(limited.out, "limpid: picture: pixels of A that are not finite, which no limit allows: 1\n");
}

// 8-bit pictures: figures of the stored numbers, as image tools give them, but Luv of light.
TEST_F(CompareCommandTest, takesStoredPicturesAsTheyAre) {
    io::writePng(path("a.png"), 1, 1, std::vector<std::uint8_t>{255, 255, 255});
    io::writePng(path("b.png"), 1, 1, std::vector<std::uint8_t>{51, 51, 51});
    const auto json = nlohmann::json::parse(compare("a.png", "b.png", "--json").out);
    EXPECT_EQ(json["values"], "sRGB as stored");
    const auto& error = json["compared"][0]["error"];
    EXPECT_NEAR(error["nmae"], 4, 1e-6);
    EXPECT_NEAR(error["psnr"], 20 * std::log10(1 / 0.8), 1e-5) << "the peak is what 8 bits can say";
    // 51 is 0.0331 in linear light: L* = 116 ∛0.0331 − 16 = 21.25.
    EXPECT_NEAR(error["luv"], 100 - 21.25, 0.03);
}

TEST_F(CompareCommandTest, leavesOutWhatTheMaskOrTheAlphasDo) {
    picture("a.exr", 1, 9);
    picture("b.exr", 1, 3);
    picture("mask.exr", 1, 0);
    EXPECT_EQ(compare("a.exr", "b.exr", "--max-error 0 --mask " + path("mask.exr")).code, 0);
    io::writeExr(path("alpha.exr"), 2, 1, {"R", "G", "B", "A"}, std::vector<float>{1, 1, 1, 1, 0, 0, 0, 0});
    const Result result = compare("a.exr", "alpha.exr", "--max-error 0");
    EXPECT_EQ(result.code, 0) << result.out;
    EXPECT_THAT(result.out, HasSubstr("pixels left out, on the object in only one of the two: 1"));
}

TEST_F(CompareCommandTest, takesFoldersMapByMap) {
    bake("a", 1, 4);
    bake("b", 1, 3);
    const Result result = compare("a", "b", "--max-nmae 0.1 --diff " + path("difference"));
    EXPECT_EQ(result.code, 1);
    EXPECT_THAT(result.out, HasSubstr("(nMAE by chance 0.001)"));
    EXPECT_THAT(result.out, HasSubstr("limpid: floor in sun: nMAE 0.25 is beyond --max-nmae 0.1\n"));
    EXPECT_EQ(io::readImage(path("difference/floor.sun.difference.exr")).data,
              (std::vector<float>{0, 0, 0, 1, 1, 1}));
    // Full red is the truth's mean, 2: half of it leaves half of the rest.
    EXPECT_EQ(io::readImage(path("difference/floor.sun.difference.png")).data,
              (std::vector<float>{1, 1, 1, 1, 128 / 255.0f, 128 / 255.0f}));
}

TEST_F(CompareCommandTest, saysInOneLineWhatCannotBeCompared) {
    picture("a.exr", 1, 2);
    io::writeExr(path("large.exr"), 3, 1, {"R", "G", "B"}, std::vector<float>(9));
    io::writeExr(path("many.exr"), 2, 1, {"X", "Y", "Z", "W"}, std::vector<float>(8));
    picture("black.exr", 0, 0);
    bake("bake", 1, 2);
    bake("other", 1, 2, "wall");
    const std::string a = path("a.exr");
    const std::pair<std::string, std::string> cases[] = {
        {"compare " + a, "limpid: B is required (see limpid --help)"},
        {"compare " + a + " " + path("none.exr"), "none.exr: expected a file, found nothing of that name"},
        {"compare " + a + " " + path("large.exr"), "large.exr, found 2 x 1"},
        {"compare " + a + " " + path("many.exr"), "expected channels R, G and B, found X, Y, Z, W"},
        {"compare " + a + " " + path("bake"), "bake: expected a picture like "},
        {"compare " + path("bake") + " " + path("none"), "/none: expected a folder like "},
        {"compare " + path("bake") + " " + path("other"), "expected a map of floor in sun as in "},
        {"compare " + a + " " + a + " --diff " + path("d.jpg"), "expected a name that ends in .png or .exr"},
        {"compare " + a + " " + a + " --mask " + path("black.exr"), "found no pixel to compare"},
        {"compare " + a + " " + a + " --max-nmae much", "--max-nmae"},
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
