#include "io/images/Images.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/Files.h"
#include "io/TempFolder.h"

namespace limpid::io {
namespace {

using test::errorOf;
using test::TempFolder;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

std::size_t fileCount(const TempFolder& folder) {
    std::size_t count = 0;
    for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder.path()))
        ++count;
    return count;
}

TEST(ExrTest, ComesBackBitByBit) {
    const TempFolder folder;
    const auto file = folder.path() / "map.exr";
    const std::vector<float> data = {0, -1.5f, 1e-30f, 1e30f, 0.1f, std::numeric_limits<float>::infinity(),
                                     7, 8};
    writeExr(file, 1, 2, {"R", "G", "B", "A"}, data);
    const FloatImage image = readImage(file);
    EXPECT_EQ(image.width, 1);
    EXPECT_EQ(image.height, 2);
    EXPECT_EQ(image.channels, 4);
    EXPECT_THAT(image.channelNames, ElementsAre("R", "G", "B", "A"));
    EXPECT_EQ(image.data, data);
    EXPECT_EQ(fileCount(folder), 1u);
}

TEST(PngTest, ComesBackScaledToOneWithRowsFromTheTop) {
    const TempFolder folder;
    const auto file = folder.path() / "picture.png";
    const std::vector<std::uint8_t> rgb = {0, 51, 255, 102, 1, 2};
    writePng(file, 1, 2, rgb);
    const FloatImage image = readImage(file);
    EXPECT_EQ(image.channels, 3);
    ASSERT_EQ(image.data.size(), rgb.size());
    for (std::size_t i = 0; i < rgb.size(); ++i)
        EXPECT_FLOAT_EQ(image.data[i], rgb[i] / 255.0f);
}

TEST(WriteTest, ReplacesWhatWasThere) {
    const TempFolder folder;
    const auto file = folder.write("picture.png", "something else");
    writePng(file, 1, 1, std::vector<std::uint8_t>{1, 2, 3});
    EXPECT_EQ(readImage(file).width, 1);
    EXPECT_EQ(fileCount(folder), 1u);
}

TEST(WriteTest, LeavesNothingBehindWhenItFails) {
    const TempFolder folder;
    const std::vector<float> data(1);
    std::filesystem::create_directory(folder.path() / "folder.exr");
    EXPECT_EQ(errorOf(folder, [&] { writeExr(folder.path() / "folder.exr", 1, 1, {"R"}, data); }),
              "folder.exr: expected a file to write to, found a folder");
    EXPECT_THAT(errorOf(folder, [&] { writeExr(folder.path() / "no/map.exr", 1, 1, {"R"}, data); }),
                StartsWith("no/map.exr: expected a folder to write to, found none named "));
    EXPECT_THAT(errorOf(folder, [&] { writeText(folder.path() / "no/index.json", "{}"); }),
                StartsWith("no/index.json: expected a folder to write to, found none named "));
    EXPECT_EQ(fileCount(folder), 1u);
}

TEST(WriteTest, AnOldFileSurvivesAFailure) {
    const TempFolder folder;
    const auto file = folder.write("out.txt", "old");
    const auto fail = [&] {
        writeWhole(file, [](const std::filesystem::path& partial) {
            std::ofstream(partial) << "half";
            throw std::runtime_error("disk\nfull");
        });
    };
    EXPECT_EQ(errorOf(folder, fail), "out.txt: cannot write: disk full");
    EXPECT_EQ(readBytes(file), (std::vector<std::uint8_t>{'o', 'l', 'd'}));
    EXPECT_EQ(fileCount(folder), 1u);
}

TEST(WriteTest, ThePartialFileLiesBesideUnderTheSameName) {
    const TempFolder folder;
    writeWhole(folder.path() / "a.b.exr", [&](const std::filesystem::path& partial) {
        EXPECT_EQ(partial.parent_path().parent_path(), folder.path());
        EXPECT_EQ(partial.filename(), "a.b.exr"); // image libraries choose the format by the suffix
        std::ofstream(partial) << "x";
    });
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "a.b.exr"));
    EXPECT_EQ(fileCount(folder), 1u);
}

TEST(WriteTest, NamesInCapitalsAreOfTheSameFormats) {
    const TempFolder folder;
    writePng(folder.path() / "OUT.PNG", 2, 1, std::vector<std::uint8_t>{1, 2, 3, 4, 5, 6});
    writeExr(folder.path() / "OUT.EXR", 2, 1, {"R"}, std::vector<float>{1, 2});
    EXPECT_FALSE(readImage(folder.path() / "OUT.PNG").floatingPoint);
    EXPECT_TRUE(readImage(folder.path() / "OUT.EXR").floatingPoint);
}

TEST(StampTest, ComesBackFromBothFormats) {
    const TempFolder folder;
    const std::vector<std::uint8_t> rgb{1, 2, 3, 4, 5, 6};
    writePng(folder.path() / "a.png", 2, 1, rgb, "0123456789abcdef");
    writeExr(folder.path() / "a.exr", 2, 1, {"R"}, std::vector<float>{1, 2}, "fedcba9876543210");
    writePng(folder.path() / "none.png", 2, 1, rgb);
    folder.write("broken.png", "no picture");
    const auto png = readStamp(folder.path() / "a.png"), exr = readStamp(folder.path() / "a.exr");
    ASSERT_TRUE(png && exr);
    EXPECT_EQ(png->width, 2);
    EXPECT_EQ(png->height, 1);
    EXPECT_EQ(png->fingerprint, "0123456789abcdef");
    EXPECT_EQ(exr->fingerprint, "fedcba9876543210");
    EXPECT_EQ(readStamp(folder.path() / "none.png")->fingerprint, "");
    for (const char* name : {"broken.png", "missing.png", "."})
        EXPECT_FALSE(readStamp(folder.path() / name)) << name;
}

TEST(HashHintTest, NamesThePatternThatIsMeant) {
    EXPECT_EQ(hashHint("f.####.png"), " (#### is written %04d)");
    EXPECT_EQ(hashHint("f#.png"), " (# is written %d)");
    EXPECT_EQ(hashHint("f%04d.png"), "");
    const TempFolder folder;
    EXPECT_EQ(errorOf(folder, [&] { requireFile(folder.path() / "h.###.exr"); }),
              "h.###.exr: expected a file, found nothing of that name (### is written %03d)");
}

TEST(TextTest, ComesBack) {
    const TempFolder folder;
    writeText(folder.path() / "t.json", "{\n}\n");
    EXPECT_EQ(readBytes(folder.path() / "t.json"), (std::vector<std::uint8_t>{'{', '\n', '}', '\n'}));
}

TEST(ReadTest, BadFilesAreErrorsOfOneLine) {
    const TempFolder folder;
    const auto read = [&](const char* name) {
        return errorOf(folder, [&] { readImage(folder.path() / name); });
    };
    folder.write("empty.exr", "");
    folder.write("text.png", "this is\nno picture");
    EXPECT_EQ(read("none.exr"), "none.exr: expected a file, found nothing of that name");
    EXPECT_EQ(read("empty.exr"), "empty.exr: expected a file, found an empty file");
    EXPECT_THAT(read("text.png"), StartsWith("text.png: cannot read: "));
    EXPECT_THAT(read("text.png"), testing::Not(HasSubstr("\n")));
}

TEST(ReadTest, TheLibraryOfABrokenPictureIsSilent) {
    const TempFolder folder;
    const auto file = folder.path() / "broken.png";
    writePng(file, 2, 1, std::vector<std::uint8_t>{1, 2, 3, 4, 5, 6});
    std::vector<std::uint8_t> bytes = readBytes(file);
    constexpr std::string_view name = "IDAT";
    const auto data = std::search(bytes.begin(), bytes.end(), name.begin(), name.end());
    ASSERT_NE(data, bytes.end());
    data[8] ^= 0x55;
    writeText(file, std::string(bytes.begin(), bytes.end()));
    testing::internal::CaptureStderr();
    EXPECT_THAT(errorOf(folder, [&] { readImage(file); }), StartsWith("broken.png: cannot read: "));
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

#ifdef LIMPID_IMAGES_LITE
TEST(ReadTest, WhatTheBuildLacksIsRefusedByName) {
    const TempFolder folder;
    const auto read = [&](const char* name) {
        return errorOf(folder, [&] { readImage(folder.path() / name); });
    };
    folder.write("a.tif", std::string("II*\0\x08\0\0\0", 8));
    folder.write("tiles.exr", std::string("v/1\x01\x02\x02\0\0", 8) + std::string(64, '\0'));
    EXPECT_EQ(read("a.tif"),
              "a.tif: cannot read: this build reads only PNG, OpenEXR, JPEG, BMP, TGA, GIF, PSD, HDR and "
              "PNM: built with LIMPID_IMAGES=lite");
    EXPECT_EQ(read("tiles.exr"),
              "tiles.exr: cannot read: this build reads OpenEXR of one part in scan lines only: built "
              "with LIMPID_IMAGES=lite");
}
#endif

TEST(OneLineTest, JoinsAndCuts) {
    EXPECT_EQ(oneLine(" a\n\n b\t"), "a b");
    EXPECT_EQ(oneLine("abcdef", 3), "abc…");
    EXPECT_EQ(oneLine("aéé", 2), "a…") << "no character is cut in two";
    EXPECT_EQ(oneLine("a\xff\x1b[31mb"), "a\\xff [31mb") << "what is not UTF-8 is spelt out";
}

TEST(Files, errorsAreFitForATerminal) {
    EXPECT_EQ(legible("Grüße, 世界 𝄞"), "Grüße, 世界 𝄞");
    EXPECT_EQ(legible("\x1b[2J\tx\ny\x7f"), "\\x1b[2J\\x09x y\\x7f");
    EXPECT_EQ(legible("\xc3"), "\\xc3") << "cut off";
    EXPECT_EQ(legible("\xc0\xaf \xed\xa0\x80 \xf4\x90\x80\x80"),
              "\\xc0\\xaf \\xed\\xa0\\x80 \\xf4\\x90\\x80\\x80")
        << "longer than need be, half of a pair, past the last plane";
}

} // namespace
} // namespace limpid::io
