// Names of outputs, sequences that go on, and what a model is told to go without, through the program itself.
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>

#include "apps/RunProgram.h"
#include "io/Files.h"
#include "io/SmallGltf.h"
#include "io/TempFolder.h"
#include "io/images/Images.h"

namespace limpid {
namespace {

namespace fs = std::filesystem;
using test::Result;
using test::run;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

class OutputCommandGLTest : public testing::Test {
  protected:
    test::TempFolder folder;
    std::string path(const char* name) const { return (folder.path() / name).string(); }
    std::string scene(const char* color) const {
        return folder
            .write("scene.toml",
                   std::string("[water]\nlevel = 1\n[[light]]\n[[receiver]]\nplane = { size = [2, 2] }\n"
                               "albedo = ") +
                       color + "\n[caustics]\nmap_size = 16\n")
            .string();
    }
    Result render(const std::string& arguments, const char* size = "16x9") const {
        return run(std::string("render --size ") + size + " --set water.grid=[16,16] " + arguments);
    }
    Result renderFrames(const std::string& arguments, const char* size = "16x9") const {
        return render(scene("[1, 0, 0]") + " --frames 0..2 -o " + path("f%02d.png") + " " + arguments, size);
    }
};

TEST_F(OutputCommandGLTest, namesInCapitalsAreOfTheSameFormats) {
    ASSERT_EQ(render(scene("[1, 1, 1]") + " -o " + path("OUT.PNG")).code, 0);
    ASSERT_EQ(render(scene("[1, 1, 1]") + " -o " + path("OUT.EXR")).code, 0);
    EXPECT_FALSE(io::readImage(path("OUT.PNG")).floatingPoint);
    EXPECT_TRUE(io::readImage(path("OUT.EXR")).floatingPoint);
}

TEST_F(OutputCommandGLTest, aLinkLeadsToThePicture) {
    fs::create_symlink("real.png", path("link.png"));
    ASSERT_EQ(render(scene("[1, 1, 1]") + " -o " + path("link.png")).code, 0);
    EXPECT_TRUE(fs::is_symlink(path("link.png")));
    EXPECT_EQ(io::readImage(path("real.png")).width, 16);
}

TEST_F(OutputCommandGLTest, aPipeGetsThePictureAndNothingElse) {
    ASSERT_EQ(render(scene("[1, 1, 1]") + " --verbose -o " + path("file.png")).code, 0);
    ASSERT_EQ(render(scene("[1, 1, 1]") + " --verbose -o /dev/stdout | cat > " + path("piped.png")).code, 0);
    EXPECT_EQ(io::readBytes(path("piped.png")), io::readBytes(path("file.png")));
    EXPECT_EQ(render(scene("[1, 1, 1]") + " -o /dev/null").code, 0);
}

TEST_F(OutputCommandGLTest, aFolderIsNoPicture) {
    fs::create_directory(path("pictures.png"));
    const Result result = render(scene("[1, 1, 1]") + " -o " + path("pictures.png"));
    EXPECT_EQ(result.code, 2);
    EXPECT_THAT(result.out, HasSubstr("pictures.png: expected a file to write to, found a folder\n"));
}

TEST_F(OutputCommandGLTest, numbersAsOtherProgramsWriteThemAreHintedAt) {
    const Result result = render(scene("[1, 1, 1]") + " --frames 0..2 -o " + path("f.####.png"));
    EXPECT_EQ(result.code, 2);
    EXPECT_THAT(result.out,
                HasSubstr("expected one %04d for the frame's number, found none (#### is written %04d)"));
}

TEST_F(OutputCommandGLTest, aSequenceGoesOnWithTheSameSceneAlone) {
    ASSERT_EQ(renderFrames("").code, 0);
    fs::remove(path("f01.png"));
    EXPECT_THAT(renderFrames("").out, HasSubstr("3 frames of 16 x 9 pixels, 2 of them there already"));
    const auto before = io::readBytes(path("f00.png"));
    const char* other =
        "expected this scene's frame of 16 x 9 pixels, or none, found one of another scene or time";
    const std::pair<const char*, const char*> others[] = {
        {"--set ambient.radiance=[1,1,1]", other},
        {"--set receiver.0.albedo=[0,1,0]", other},
        {"--set camera.exposure=1", other},
        {"--method volumetric", other},
    };
    for (const auto& [change, found] : others) {
        const Result result = renderFrames(change);
        EXPECT_EQ(result.code, 2) << change;
        EXPECT_THAT(result.out, AllOf(HasSubstr("f00.png: "), HasSubstr(found), HasSubstr("--overwrite")));
        EXPECT_EQ(std::count(result.out.begin(), result.out.end(), '\n'), 1) << result.out;
    }
    const Result larger = renderFrames("", "32x18");
    EXPECT_EQ(larger.code, 2);
    EXPECT_THAT(
        larger.out,
        HasSubstr(
            "expected this scene's frame of 32 x 18 pixels, or none, found one of 16 x 9; --overwrite"));
    EXPECT_EQ(io::readBytes(path("f00.png")), before) << "nothing lost";
    EXPECT_THAT(renderFrames("--overwrite", "32x18").out,
                AllOf(HasSubstr("3 frames of 32 x 18 pixels"), Not(HasSubstr("there already"))));
    for (const char* name : {"f00.png", "f01.png", "f02.png"})
        EXPECT_EQ(io::readImage(path(name)).width, 32) << name;
}

TEST_F(OutputCommandGLTest, framesKnowTheirTime) {
    ASSERT_EQ(renderFrames("--fps 10").code, 0);
    const Result result = renderFrames("--fps 20");
    EXPECT_EQ(result.code, 2);
    EXPECT_THAT(result.out, HasSubstr("f01.png: ")) << "frame 0 is at 0 s either way";
}

TEST_F(OutputCommandGLTest, aPictureFromElsewhereIsNotTakenForAFrame) {
    io::writePng(path("f01.png"), 16, 9, std::vector<std::uint8_t>(16 * 9 * 3));
    const Result result = renderFrames("");
    EXPECT_EQ(result.code, 2);
    EXPECT_THAT(result.out, HasSubstr("found another picture"));
    EXPECT_FALSE(fs::exists(path("f00.png"))) << "nothing is begun";
}

TEST_F(OutputCommandGLTest, aModelAloneGoesWithoutWhatItIsTold) {
    test::SmallGltf gltf = test::triangleGltf();
    gltf.addMesh({{"attributes", {{"POSITION", 0}}}});
    gltf.json["nodes"][1]["name"] = "Pool Water";
    const std::string pool = folder.write("pool.glb", gltf.glb()).string();
    const std::string out = " --map-size 16 -o " + path("a.png");
    Result result = render(pool + out);
    EXPECT_EQ(result.code, 0);
    EXPECT_THAT(result.out, HasSubstr("warning: receiver.pool: expected no water but the scene's own, found "
                                      "\"Pool Water\" (water by its name); without = [\"Pool Water\"]"));
    EXPECT_EQ(render(pool + out + " --quiet").out, "");
    result = render(pool + out + " --without 'Pool*' --without Lid");
    EXPECT_EQ(result.code, 0);
    EXPECT_THAT(result.out, AllOf(Not(HasSubstr("water by its name")), HasSubstr("found \"Lid\"")));
    result = render(scene("[1, 1, 1]") + " --without 'Pool*' -o " + path("b.png"));
    EXPECT_EQ(result.code, 2);
    EXPECT_THAT(result.out, HasSubstr("in a scene it is a receiver's key, without = [\"Pool*\"]"));
}

} // namespace
} // namespace limpid
