// tools/gpu-check without a GPU: what it makes of wrong arguments, and of a bundle whose programs are shell
// scripts.

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include "io/Files.h"
#include "io/TempFolder.h"

namespace limpid {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

class GpuCheckTest : public testing::Test {
  protected:
    const test::TempFolder folder;
    fs::path root() const { return folder.path() / "limpid-gpu"; }

    std::string text(const fs::path& file) const {
        const auto bytes = io::readBytes(file);
        return {bytes.begin(), bytes.end()};
    }

    /// Its exit status; what it says lies in said.
    int check(const std::string& arguments) const {
        const std::string said = (folder.path() / "said").string();
        const std::string command = "cd " + folder.path().string() + " && " LIMPID_ROOT "/tools/gpu-check " +
                                    arguments + " >" + said + " 2>&1";
        return WEXITSTATUS(std::system(command.c_str()));
    }

    void script(const std::string& name, std::string lines, const std::string& maps = "") const {
        if (const auto at = lines.find("MAPS"); at != lines.npos) lines.replace(at, 4, maps);
        fs::create_directories((root() / name).parent_path());
        std::ofstream(root() / name) << "#!/bin/sh\n" << lines;
        fs::permissions(root() / name, fs::perms::owner_all);
    }

    /// `maps`: what a bake writes into its map.
    void makeBundle(const std::string& maps) const {
        script("build/limpid", R"sh(
case $1 in
info) echo 'GPU       Fake 3000'; echo 'OpenGL    4.6 fake' ;;
bake) mkdir -p "$4"; echo MAPS >"$4/a.exr" ;;
compare) echo 'a in sun  10  0.0002  0 0 inf 0 1 0 at 0,0' ;;
render) : >"$(printf "$4" 0)" ;;
profile)
    mkdir -p "$6"
    printf 'scene,method,caustics_ms:median\nflat,exact-beam,1.5\nflat,stencil,12\n' >"$6/results.csv" ;;
esac
)sh",
               maps);
        script("build/tests/EngineGLTests", "echo '[       OK ] A.b (1 ms)'\n");
        script("build/tests/WaterGLTests", "echo '[  FAILED  ] Beams.refract (3 ms)'; exit 1\n");
        for (const char* name : {"quick", "cost-receivers", "cost-beams", "godrays"}) {
            fs::create_directories(root() / "profiles");
            std::ofstream(root() / "profiles" / (std::string(name) + ".toml"))
                << "scene = \"a\"\nframes = 3\n";
        }
        const std::string pack = "tar -C " + folder.path().string() + " -cJf " +
                                 (folder.path() / "b.tar.xz").string() + " limpid-gpu";
        ASSERT_EQ(std::system(pack.c_str()), 0);
    }
};

TEST_F(GpuCheckTest, wrongArgumentsAreTwoAndOneLine) {
    for (const auto& [arguments, found] :
         {std::pair("--fast", "found --fast"),
          {"none.tar.xz", "none.tar.xz: expected a bundle, found no such file"},
          {"--out", "--out: expected a folder, found nothing"}}) {
        EXPECT_EQ(check(arguments), 2) << arguments;
        EXPECT_THAT(text(folder.path() / "said"), HasSubstr(found));
    }
}

TEST_F(GpuCheckTest, aFailedStepIsToldAndTheOthersRun) {
    makeBundle("same");
    EXPECT_EQ(check("b.tar.xz --out out"), 1);
    const std::string summary = text(folder.path() / "out/summary.md");
    for (const char* row :
         {"# Limpid on a GPU: Fake 3000", "| info | ok |", "teapot: same bits, nMAE 0.0002 against",
          "overflow-1: same bits", "| pictures | ok |", "2 medians, 1.5 to 12 ms",
          "| the other tests | failed |", "1 passed, failed: Beams.refract",
          "| cost-beams | scene flat, method exact-beam | 1.5 |"})
        EXPECT_THAT(summary, HasSubstr(row));
    for (const char* file : {"logs.txt", "results.tar.xz", "teapot.png"})
        EXPECT_TRUE(fs::exists(folder.path() / "out" / file)) << file;
}

TEST_F(GpuCheckTest, otherBitsFail) {
    makeBundle("$$"); // the number of the process
    EXPECT_EQ(check("b.tar.xz --out out --quick"), 1);
    EXPECT_THAT(text(folder.path() / "out/summary.md"), HasSubstr("| overflow, three times | failed |"));
}

} // namespace
} // namespace limpid
