// The program, ended by a signal in the midst of its work: it dies of that signal, nothing half-written is
// left, and what stood there before is still there, or is whole.
#include <chrono>
#include <csignal>
#include <functional>
#include <map>
#include <thread>

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <spawn.h>

#include "apps/RunProgram.h"
#include "io/Files.h"
#include "io/TempFolder.h"
#include "io/bake/BakedFolder.h"
#include "io/images/Images.h"

namespace limpid {
namespace {

using test::run;
namespace fs = std::filesystem;

const std::string box = test::rootFolder() + "/models/box.glb";

/// Every file and folder below `folder`, and what is in the files.
std::map<std::string, std::vector<std::uint8_t>> contents(const fs::path& folder) {
    std::map<std::string, std::vector<std::uint8_t>> found;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        found[entry.path().string()] =
            entry.is_regular_file() ? io::readBytes(entry) : std::vector<std::uint8_t>();
    return found;
}

class KilledGLTest : public testing::TestWithParam<int> {
  protected:
    std::string path(const std::string& name) const { return (folder.path() / name).string(); }

    /// Starts the program and sends it the signal as soon as `midst`, which is given its number, is so.
    void expectDies(const std::string& arguments, const std::function<bool(pid_t)>& midst) {
        const std::string command = fmt::format("exec {}/limpid {}", test::buildFolder(), arguments);
        const char* words[] = {"sh", "-c", command.c_str(), nullptr};
        posix_spawn_file_actions_t actions;
        posix_spawn_file_actions_init(&actions);
        for (const int stream : {1, 2})
            posix_spawn_file_actions_addopen(&actions, stream, path("said").c_str(),
                                             O_WRONLY | O_CREAT | O_APPEND, 0600);
        // Even if this test is a shell's background job, which ignores SIGINT.
        posix_spawnattr_t attributes;
        posix_spawnattr_init(&attributes);
        sigset_t all;
        sigfillset(&all);
        posix_spawnattr_setsigdefault(&attributes, &all);
        posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF);
        pid_t process = 0;
        ASSERT_EQ(posix_spawn(&process, "/bin/sh", &actions, &attributes, const_cast<char**>(words), environ),
                  0);
        posix_spawn_file_actions_destroy(&actions);
        posix_spawnattr_destroy(&attributes);
        int status = 0;
        const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
        bool reached = false;
        while (!(reached = midst(process)) && waitpid(process, &status, WNOHANG) == 0 &&
               std::chrono::steady_clock::now() < end)
            std::this_thread::sleep_for(std::chrono::microseconds(100));
        EXPECT_TRUE(reached) << arguments;
        kill(process, GetParam());
        waitpid(process, &status, 0);
        EXPECT_EQ(WIFSIGNALED(status) ? WTERMSIG(status) : 0, GetParam()) << arguments;
        EXPECT_EQ(fs::file_size(path("said")), 0u) << "and says nothing";
        fs::remove(path("said"));
    }

    /// Whether the program is writing something into `name`.
    auto writesIn(const std::string& name) const {
        return [this, name](pid_t process) {
            return fs::exists(path(name) + fmt::format("/.partial-{}", process));
        };
    }

    /// Ends `command`, which a map size is still to be added to, while it writes `name`. Small maps stand
    /// there before; large ones take a while to write.
    void expectTheOneBefore(const std::string& command, const std::string& name) {
        ASSERT_EQ(run(command + "48").code, 0);
        const auto before = contents(folder.path());
        expectDies(command + "512", writesIn(name));
        EXPECT_TRUE(contents(folder.path()) == before);
    }

    test::TempFolder folder;
};

const std::string maps = " --quiet --set water.grid=[16,16] --map-size ";

TEST_P(KilledGLTest, aBakeLeavesTheOneBefore) {
    expectTheOneBefore("bake " + box + " -o " + path("maps") + maps, "maps");
}

#ifdef LIMPID_WITH_REFERENCE
TEST_P(KilledGLTest, aReferenceLeavesTheOneBefore) {
    expectTheOneBefore("reference " + box + " --photons 20000 -o " + path("truth") + maps, "truth");
}

TEST_P(KilledGLTest, aProfileLeavesTheResultsBefore) {
    folder.write("scene.toml",
                 "[[receiver]]\nsphere = { radius = 0.5 }\ntranslation = [0, -1, 0]\n[[light]]\n");
    const std::string profile = folder
                                    .write("tiny.toml", "scene = \"scene.toml\"\nmethods = [\"exact-beam\"]\n"
                                                        "map_sizes = 16\ngrids = [[8, 8]]\nframes = 1\n"
                                                        "picture = [8, 8]\n")
                                    .string();
    const std::string command = "profile " + profile + " --quiet -o " + path("out");
    ASSERT_EQ(run(command).code, 0);
    const auto before = contents(path("out"));
    // The first that it writes is the ground truth, when it has measured.
    expectDies(command + " --reference 20000 --frames 1000",
               [&](pid_t) { return fs::exists(path("out/references")); });
    for (const auto& [name, bytes] : contents(path("out"))) {
        EXPECT_EQ(name.find(".partial"), name.npos) << name;
        const auto old = before.find(name);
        EXPECT_TRUE(old == before.end() || old->second == bytes) << name;
    }
}
#endif

TEST_P(KilledGLTest, aSequenceIsWholePictures) {
    for (const char* suffix : {"png", "exr"}) {
        const std::string second = path(fmt::format("f0001.{}", suffix));
        expectDies("render " + box +
                       " --size 320x180 --fps 10 --frames 0..9999 --quiet --set water.grid=[16,16] "
                       "--map-size 48 -o " +
                       path(fmt::format("f%04d.{}", suffix)),
                   [&](pid_t process) { return fs::exists(second) && writesIn("")(process); });
    }
    std::size_t pictures = 0;
    for (const auto& entry : fs::directory_iterator(folder.path())) {
        ASSERT_TRUE(entry.is_regular_file()) << entry;
        EXPECT_EQ(io::readImage(entry.path()).data.size(), 320u * 180 * 3) << entry;
        ++pictures;
    }
    EXPECT_GE(pictures, 4u);
}

TEST_P(KilledGLTest, aVideoIsNotThere) {
    // In ffmpeg's place, as that may not be installed: what is given to it goes where it is told to write.
    const fs::path ffmpeg =
        folder.write("bin/ffmpeg", "#!/bin/sh\nfor file; do :; done\nexec cat >\"$file\"\n");
    fs::permissions(ffmpeg, fs::perms::owner_all);
    const std::string usual = std::getenv("PATH");
    setenv("PATH", fmt::format("{}:{}", ffmpeg.parent_path().string(), usual).c_str(), 1);
    const auto before = contents(folder.path());
    expectDies("render " + box +
                   " --size 64x36 --fps 10 --frames 0..9999 --quiet --set water.grid=[16,16] "
                   "--map-size 48 -o " +
                   path("a.mp4"),
               [&](pid_t process) { return fs::exists(path(fmt::format(".partial-{}/a.mp4", process))); });
    setenv("PATH", usual.c_str(), 1);
    EXPECT_TRUE(contents(folder.path()) == before);
}

INSTANTIATE_TEST_SUITE_P(Signals, KilledGLTest, testing::Values(SIGINT, SIGTERM),
                         [](const auto& test) { return std::string(sigabbrev_np(test.param)); });

} // namespace
} // namespace limpid
