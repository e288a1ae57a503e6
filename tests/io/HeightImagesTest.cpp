#include "io/images/HeightImages.h"

#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "io/StoredPng.h"
#include "io/TempFolder.h"
#include "io/images/Images.h"
#include "io/toml/SceneFile.h"

namespace limpid::io {
namespace {

using test::errorOf;
using test::TempFolder;

constexpr int side = 12;

void writeHeights(const std::filesystem::path& file, const std::vector<float>& heights, int width = side) {
    writeExr(file, width, int(heights.size()) / width, {"Y"}, heights);
}
std::vector<float> constant(float height, int count = side * side) {
    return std::vector<float>(std::size_t(count), height);
}

/// The height at the middle of a field whose neighbourhood is constant: its coefficients are all that height.
double middle(const HeightField& field) {
    return double(field.spline[std::size_t(field.size.y / 2) * std::size_t(field.size.x) +
                               std::size_t(field.size.x / 2)]);
}

class HeightImagesTest : public testing::Test {
  protected:
    const TempFolder folder;

    std::string openError(const char* name) {
        return errorOf(folder, [&] { openHeightImages(folder.path() / name, {0, 0}); });
    }
    std::string sceneError(const std::string& wave) {
        const auto file = folder.write("scene.toml", "[[receiver]]\nplane = { size = [2, 2] }\n" + wave);
        return errorOf(folder, [&] { loadScene(file); });
    }
};

TEST_F(HeightImagesTest, floatingPointIsTakenAsItIs) {
    writeHeights(folder.path() / "h.exr", constant(-2.5f, 40 * 40), 40);
    const auto source = openHeightImages(folder.path() / "h.exr", {0, 0});
    EXPECT_EQ(source->frameCount(), 1);
    EXPECT_EQ(source->bounds().size, glm::ivec2(40, 40));
    EXPECT_NEAR(middle(*source->frame(0)), -2.5, 1e-5);
    // At the edge, where the heights end abruptly, the spline overshoots.
    EXPECT_GE(source->bounds().highest, 2.5);
    EXPECT_LT(source->bounds().highest, 2.5 * 1.7);
}

TEST_F(HeightImagesTest, integersRunFromMinusOneToOneAndAlphaIsLeftOut) {
    const auto heightOf = [&](const char* name) {
        return middle(*openHeightImages(folder.path() / name, {0, 0})->frame(0));
    };
    // Four channels, the first constant, alpha at half of its range.
    folder.write("8.png", test::storedPng(40, 8, {204, 127, 127, 127}));
    folder.write("16.png", test::storedPng(40, 16, {13107, 32767, 32767, 32767}));
    EXPECT_NEAR(heightOf("8.png"), 2 * 0.8 - 1, 1e-5);
    EXPECT_NEAR(heightOf("16.png"), 2 * 0.2 - 1, 1e-5);
}

TEST_F(HeightImagesTest, aSequenceStartsAtItsLowestNumber) {
    for (const int number : {9, 10, 11})
        writeHeights(folder.path() / fmt::format("h.{:02}.exr", number), constant(float(number), 40 * 40),
                     40);
    writeHeights(folder.path() / "h.0012.exr", constant(0)); // four digits: of another sequence
    writeHeights(folder.path() / "h.13.bak.exr", constant(0));
    const auto source = openHeightImages(folder.path() / "h.%02d.exr", {0, 0});
    ASSERT_EQ(source->frameCount(), 3);
    for (const int i : {0, 1, 2, 0})
        EXPECT_NEAR(middle(*source->frame(i)), 9 + i, 1e-4);
}

TEST_F(HeightImagesTest, theLastTwoFramesAreKept) {
    for (const int number : {0, 1, 2})
        writeHeights(folder.path() / fmt::format("{}.exr", number), constant(float(number)));
    const auto source = openHeightImages(folder.path() / "%d.exr", {0, 0});
    const auto first = source->frame(0), second = source->frame(1);
    std::filesystem::remove(folder.path() / "0.exr");
    EXPECT_EQ(source->frame(0), first);
    EXPECT_EQ(source->frame(1), second);
    source->frame(2);
    EXPECT_EQ(source->frame(1), second);
    EXPECT_EQ(errorOf(folder, [&] { source->frame(0); }),
              "0.exr: expected a file, found nothing of that name");
    EXPECT_EQ(source->frame(1), second) << "an error leaves the other frame";
}

TEST_F(HeightImagesTest, badFilesAreNamed) {
    writeHeights(folder.path() / "gap.1.exr", constant(0));
    writeHeights(folder.path() / "gap.3.exr", constant(0));
    writeHeights(folder.path() / "small.exr", constant(0, 7 * 12), 12);
    writeHeights(folder.path() / "wide.exr", constant(0, 8 * 8193), 8193);
    std::vector<float> hole = constant(0);
    hole[2 * side + 5] = NAN;
    writeHeights(folder.path() / "hole.exr", hole);
    EXPECT_EQ(openError("none.exr"), "none.exr: expected a file, found nothing of that name");
    EXPECT_EQ(openError("none.%04d.exr"),
              "none.%04d.exr: expected the files of a sequence, found none of that name");
    EXPECT_EQ(openError("no/where.%d.exr"),
              "no/where.%d.exr: expected the files of a sequence, found none of that name");
    EXPECT_EQ(openError("gap.%d.exr"), "gap.2.exr: expected a file, found nothing of that name");
    EXPECT_EQ(openError("small.exr"), "small.exr: expected 8 to 8192 pixels a side, found 12 x 7");
    EXPECT_EQ(openError("wide.exr"), "wide.exr: expected 8 to 8192 pixels a side, found 8193 x 8");
    EXPECT_EQ(openError("hole.exr"),
              "hole.exr: expected heights from -1e12 to 1e12, found nan in row 2, column 5");
    for (const char* name : {"a.%s.exr", "a.%4d.exr", "a.%00d.exr", "%d.%d.exr", "100%.exr", "%"})
        EXPECT_EQ(openError(name),
                  std::string(name) + ": expected one %04d for the frame's number, found another pattern");
}

TEST_F(HeightImagesTest, allFramesHaveOneSize) {
    writeHeights(folder.path() / "h0.exr", constant(0));
    writeHeights(folder.path() / "h1.exr", constant(0, 12 * 13));
    const auto source = openHeightImages(folder.path() / "h%d.exr", {0, 0});
    EXPECT_EQ(errorOf(folder, [&] { source->frame(1); }),
              "h1.exr: expected 12 x 12 pixels as in the first frame, found 12 x 13");
}

TEST_F(HeightImagesTest, scenesPlaceThem) {
    std::filesystem::create_directory(folder.path() / "maps");
    writeHeights(folder.path() / "maps/h.07.exr", constant(1, 64 * 32), 64);
    const auto file = folder.write("scene.toml", R"([water]
[[water.wave]]
type = "heightmap"
image = "maps/h.%02d.exr"
amplitude = 0.02
placement = [1, -2, 4, 3]
fps = 24
[[receiver]]
plane = { size = [2, 2] }
)");
    const Scene scene = loadScene(file);
    ASSERT_EQ(scene.water.waves.size(), 1u);
    const Wave& wave = scene.water.waves[0];
    EXPECT_EQ(wave.type, WaveType::HeightMap);
    EXPECT_EQ(wave.amplitude, 0.02);
    EXPECT_EQ(wave.center, glm::dvec2(1, -2));
    EXPECT_EQ(wave.size, glm::dvec2(4, 3));
    EXPECT_EQ(wave.fps, 24);
    ASSERT_TRUE(wave.heights);
    EXPECT_EQ(wave.heights->bounds().size, glm::ivec2(64, 32));
    // By default it fades over a sixteenth of the shorter side, here three texels of 1/16 m: with no fade the
    // overshoot of the spline is 1.27² at the corners. Over a metre it is 16 texels.
    EXPECT_LT(wave.heights->bounds().highest, 1.27 * 1.27);
    EXPECT_NEAR(loadScene(file, {{"water.wave.0.fade", "1"}}).water.waves[0].heights->bounds().steepest.x,
                1.875 / 16, 0.05 * 1.875 / 16);
}

TEST_F(HeightImagesTest, sceneErrorsNameTheKey) {
    writeHeights(folder.path() / "h.exr", constant(0));
    const std::string wave = "[[water.wave]]\ntype = \"heightmap\"\n";
    const std::string placed = wave + "placement = [0, 0, 1, 1]\n";
    EXPECT_EQ(sceneError(wave + "placement = [0, 0, 1, 1]"),
              "scene.toml:3:1: water.wave.0.image: expected the path of an image, or of a sequence with one "
              "%04d, found nothing");
    EXPECT_EQ(sceneError(placed + "image = 3"),
              "scene.toml:6:9: water.wave.0.image: expected the path of an image, or of a sequence with one "
              "%04d, found 3");
    EXPECT_EQ(
        sceneError(wave + "image = \"h.exr\""),
        "scene.toml:3:1: water.wave.0.placement: expected [x, z, width, depth] with width and depth > 0, "
        "found nothing");
    EXPECT_EQ(sceneError(wave + "image = \"h.exr\"\nplacement = [0, 0, 1, 0]"),
              "scene.toml:6:13: water.wave.0.placement: expected [x, z, width, depth] with width and depth > "
              "0, found [0, 0, 1, 0]");
    EXPECT_EQ(
        sceneError(placed + "image = \"none.%04d.exr\""),
        "scene.toml:6:9: water.wave.0.image: none.%04d.exr: expected the files of a sequence, found none "
        "of that name");
    EXPECT_EQ(sceneError(placed + "image = \"h.exr\"\nfps = 0"),
              "scene.toml:7:7: water.wave.0.fps: expected a number > 0 and <= 1e12, found 0");
    EXPECT_EQ(sceneError(placed + "image = \"h.exr\"\nwavelength = 1"),
              "scene.toml:7:1: water.wave.0.wavelength: unknown key of a heightmap wave, expected one of "
              "amplitude, fade, fps, image, placement, type");
    std::string five;
    for (int i = 0; i < 5; ++i)
        five += placed + "image = \"h.exr\"\n";
    EXPECT_EQ(sceneError(five), "scene.toml:3:1: water.wave: expected at most 4 height maps and spectra, found 5");
}

TEST_F(HeightImagesTest, stepsAreThoseOfTheFile) {
    const std::vector<std::uint8_t> bytes(8 * 8 * 3, 128);
    writePng(folder.path() / "h.png", 8, 8, bytes);
    EXPECT_NEAR(openHeightImages(folder.path() / "h.png", glm::dvec2(0))->step(), 2.0 / 255, 1e-12);
    writeExr(folder.path() / "h.exr", 8, 8, {"Y"}, std::vector<float>(64));
    EXPECT_EQ(openHeightImages(folder.path() / "h.exr", glm::dvec2(0))->step(), 0);
}

} // namespace
} // namespace limpid::io
