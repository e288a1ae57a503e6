// What fails under the program: disk, shaders, memory, the process itself. There is one line that says so,
// the right exit code, no half file under a name that was asked for, and what stood there before is still
// there.
#include <map>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "apps/RunProgram.h"
#include "io/TempFolder.h"
#include "io/bake/BakedFolder.h"
#include "io/images/Images.h"

namespace limpid {
namespace {

using test::Result;
using test::run;
using ::testing::HasSubstr;
namespace fs = std::filesystem;

const std::string quick = " --quiet --set water.grid=[16,16] --map-size 48 --planes 3";
const std::string box = test::rootFolder() + "/models/box.glb";

/// Every file below `folder` and what is in it, hidden ones left out.
std::map<std::string, std::string> contents(const fs::path& folder) {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        const std::string name = fs::relative(entry.path(), folder).string();
        if (!entry.is_regular_file() || name.find("/.") != name.npos || name.starts_with(".")) continue;
        std::stringstream bytes;
        bytes << std::ifstream(entry.path(), std::ios::binary).rdbuf();
        files[name] = bytes.str();
    }
    return files;
}

std::size_t entries(const fs::path& folder) {
    return std::size_t(std::distance(fs::recursive_directory_iterator(folder), {}));
}

void expectOneLine(const Result& result, int code, const std::string& text) {
    EXPECT_EQ(result.code, code) << result.out;
    EXPECT_THAT(result.out, HasSubstr(text));
    EXPECT_EQ(std::count(result.out.begin(), result.out.end(), '\n'), 1) << result.out;
}

class FaultsGLTest : public testing::Test {
  protected:
    std::string path(const std::string& name) const { return (folder.path() / name).string(); }

    /// Runs a command that writes, and again with another result onto a disk that is full after 512 bytes:
    /// the shell's limit ends a write as a full disk does, with the file cut off there.
    void expectSurvivesFullDisk(const std::string& command, const std::string& change) {
        const Result before = run(command);
        ASSERT_EQ(before.code, 0) << before.out;
        const auto files = contents(folder.path());
        const std::size_t count = entries(folder.path());
        expectOneLine(run(command + change, "ulimit -f 1;"), 2, "cannot write");
        EXPECT_TRUE(contents(folder.path()) == files) << command;
        EXPECT_EQ(entries(folder.path()), count) << "nothing half-written";
    }

    test::TempFolder folder;
};

TEST_F(FaultsGLTest, aFullDiskLeavesWhatWasThere) {
    for (const char* picture : {"a.png", "a.exr"})
        expectSurvivesFullDisk("render " + box + " -o " + path(picture) + " --size 64x36" + quick,
                               " --time 1 --set camera.exposure=1 --set light.sun.irradiance=[1,2,1]");
    expectSurvivesFullDisk("bake " + box + " -o " + path("maps") + quick,
                           " --set light.sun.irradiance=[1,2,1]");
}

#ifdef LIMPID_WITH_REFERENCE
TEST_F(FaultsGLTest, aFullDiskLeavesTheGroundTruth) {
    expectSurvivesFullDisk("reference " + box + " --photons 20000 -o " + path("truth") + quick,
                           " --set light.sun.irradiance=[1,2,1]");
}
#endif

TEST_F(FaultsGLTest, aFullDiskLeavesAProfilesResults) {
    folder.write("scene.toml",
                 "[[receiver]]\nsphere = { radius = 0.5 }\ntranslation = [0, -1, 0]\n[[light]]\n");
    const std::string profile =
        folder
            .write("tiny.toml",
                   "scene = \"scene.toml\"\nmethods = [\"exact-beam\", \"level-map\"]\nplanes = [3, 5]\n"
                   "map_sizes = 16\ngrids = [[8, 8]]\nframes = 1\npicture = [8, 8]\n")
            .string();
    expectSurvivesFullDisk("profile " + profile + " --quiet -o " + path("out"), " --frames 2");
}

TEST_F(FaultsGLTest, aVideoIsWholeOrNotThere) {
    const Result result =
        run("render " + box + " -o " + path("a.mp4") + " --size 64x36 --frames 0..2" + quick, "ulimit -f 1;");
    expectOneLine(result, 2, "ffmpeg"); // full, or not installed
    EXPECT_EQ(entries(folder.path()), 0u);
}

TEST_F(FaultsGLTest, aPlaceThatTakesNoFiles) {
    // Nobody can make files in /proc, the administrator included.
    expectOneLine(run("render " + box + " -o /proc/limpid.png --size 16x9" + quick), 2, "/proc");
    expectOneLine(run("bake " + box + " -o /proc/limpid" + quick), 2, "expected a folder to write to");
    expectOneLine(run("bake " + box + " -o /proc" + quick), 2, "/proc");
    // A folder in the way of one of the maps, or of a picture.
    fs::create_directories(path("maps/box.sun.normal.exr"));
    fs::create_directories(path("a.png"));
    expectOneLine(run("bake " + box + " -o " + path("maps") + quick), 2, "it is a folder");
    expectOneLine(run("render " + box + " -o " + path("a.png") + " --size 16x9" + quick), 2,
                  "expected a file to write to, found a folder");
    EXPECT_EQ(entries(folder.path()), 3u) << "just what was there";
}

TEST_F(FaultsGLTest, aFullDiskBehindStandardOutput) {
    for (const char* command : {"info", "info --json", "man", "completion", "--help"})
        expectOneLine(run(std::string(command) + " >/dev/full)", "("), 2, "limpid: ");
    EXPECT_EQ(run("render " + box + " --size 16x9 --set water.grid=[8,8] --map-size 16 -o " + path("a.png") +
                      " 2>/dev/null >/dev/full)",
                  "(")
                  .code,
              2);
    EXPECT_EQ(run("info --nonsense >/dev/full").code, 2) << "and nobody to tell";
    EXPECT_EQ(io::readImage(path("a.png")).width, 16) << "what was asked for is there nevertheless";
}

TEST_F(FaultsGLTest, aKilledSequenceHasWholePicturesAndGoesOn) {
    const std::string command =
        "render " + box + " --size 320x180 --fps 10" + quick + " -o " + path("f%04d.exr");
    run(command + " --frames 0..9999 & p=$!; while [ ! -e " + path("f0001.exr") +
        " ] && kill -0 $p; do :; done; " + "kill -KILL $p; wait $p;");
    ASSERT_TRUE(fs::exists(path("f0001.exr")));
    int whole = 0;
    for (const auto& entry : fs::directory_iterator(folder.path()))
        if (entry.path().filename().string().find("partial") == std::string::npos) {
            EXPECT_EQ(io::readImage(entry.path()).data.size(), 320u * 180 * 3) << entry.path();
            ++whole;
        }
    const std::string first = contents(folder.path())["f0000.exr"];
    EXPECT_EQ(run(command + fmt::format(" --frames 0..{}", whole)).code, 0);
    EXPECT_EQ(io::readImage(path(fmt::format("f{:04d}.exr", whole))).width, 320);
    EXPECT_EQ(contents(folder.path())["f0000.exr"], first);
}

TEST_F(FaultsGLTest, aKilledBakeLeavesTheOneBefore) {
    const std::string command =
        "bake " + box + " --quiet --set water.grid=[16,16] --map-size 512 -o " + path("maps");
    ASSERT_EQ(run(command).code, 0);
    const auto before = contents(path("maps"));
    run(command + " --set light.sun.irradiance=[1,2,1] & p=$!; while [ ! -e " + path("maps") +
        "/.partial-$p ] && kill -0 $p; do :; done; kill -KILL $p; wait $p;");
    // Killed while it wrote its first maps; had it come to the names, the index would be gone or new.
    EXPECT_TRUE(contents(path("maps")) == before);
    EXPECT_EQ(io::readBake(path("maps")).maps.size(), 2u);
}

TEST_F(FaultsGLTest, noRoomOnTheGpuIsThree) {
    const std::string command = "render " + box +
                                " --size 320x180 --map-size 512 --planes 3 --set water.grid=[128,128] "
                                "--quiet -o " +
                                path("a.png");
    const Result small = run(command + " --gpu-memory 1");
    expectOneLine(small, 3, "bytes on the GPU, found ");
    EXPECT_THAT(small.out, HasSubstr("of the 1048576 that are allowed (--gpu-memory)"));
    EXPECT_EQ(entries(folder.path()), 0u);
    expectOneLine(run(command + " --gpu-memory 12"), 3, "bytes on the GPU, found ");
    EXPECT_EQ(run(command + " --gpu-memory 1000").code, 0);
    EXPECT_EQ(run(command + " --gpu-memory 0").code, 2);
}

TEST_F(FaultsGLTest, aLostContextIsThree) {
    const auto lost = [](int after) {
        return fmt::format("LD_PRELOAD={} LOST_AFTER={}", test::buildFolder() + "/tests/" LOST_CONTEXT,
                           after);
    };
    const std::string line = "OpenGL: expected the GPU to stay, found it reset by another program";
    expectOneLine(run("render " + box + " --size 16x9 -o " + path("a.png") + quick, lost(0)), 3, line);
    EXPECT_EQ(entries(folder.path()), 0u);
    const std::string bake = "bake " + box + " -o " + path("maps") + quick;
    ASSERT_EQ(run(bake, lost(1000)).code, 0);
    const auto before = contents(folder.path());
    for (const int after : {0, 2, 4})
        expectOneLine(run(bake + " --set light.sun.irradiance=[1,2,1]", lost(after)), 3, line);
    EXPECT_TRUE(contents(folder.path()) == before);
    // Of a sequence, what was there before the reset stays.
    expectOneLine(
        run("render " + box + " --size 16x9 --fps 10 --frames 0..999 -o " + path("f%04d.png") + quick,
            lost(4)),
        3, line);
    EXPECT_EQ(io::readImage(path("f0000.png")).width, 16);
    EXPECT_FALSE(fs::exists(path("f0009.png")));
    for (const auto& [name, bytes] : contents(folder.path()))
        EXPECT_EQ(name.find("partial"), name.npos) << name;
}

TEST_F(FaultsGLTest, aShaderThatDoesNotCompileIsThree) {
    fs::copy(test::rootFolder() + "/shaders", path("shaders"), fs::copy_options::recursive);
    std::ofstream(path("shaders/water/beams.comp"), std::ios::app) << "\nnonsense;\n";
    const Result result =
        run("bake " + box + " -o " + path("maps") + quick, "LIMPID_SHADERS=" + path("shaders"));
    EXPECT_EQ(result.code, 3);
    EXPECT_THAT(result.out, HasSubstr("limpid: shaders/water/beams.comp: does not compile: "));
    EXPECT_FALSE(fs::exists(path("maps/index.json")));
}

} // namespace
} // namespace limpid
