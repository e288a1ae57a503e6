// Ended by the user in the midst of writing: nothing half-written is left, and what stood there before is.
#include "io/Staging.h"

#include <csignal>
#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "io/Files.h"
#include "io/TempFolder.h"

namespace limpid::io {
namespace {

using test::TempFolder;
using testing::ElementsAre;
using testing::UnorderedElementsAre;
namespace fs = std::filesystem;

std::vector<std::string> names(const TempFolder& folder) {
    std::vector<std::string> found;
    for (const auto& entry : fs::directory_iterator(folder.path()))
        found.push_back(entry.path().filename().string());
    return found;
}

std::string textOf(const fs::path& file) {
    const auto bytes = readBytes(file);
    return {bytes.begin(), bytes.end()};
}

/// Runs `write(reached)` in a process of its own, sends it `signal` once it has called reached(), and gives
/// what waitpid says of its end. Of the signals it ignores `ignored` only, whatever this process does.
template <typename Write>
int endInTheMidst(int signal, Write write, int ignored = 0) {
    int ends[2];
    if (::pipe(ends) != 0) return -1;
    const pid_t process = ::fork();
    if (process == 0) {
        for (const int each : {SIGINT, SIGTERM, SIGHUP})
            std::signal(each, each == ignored ? SIG_IGN : SIG_DFL);
        removeStagingsOnSignals();
        write([&] { [[maybe_unused]] const ssize_t written = ::write(ends[1], "!", 1); });
        ::_exit(0);
    }
    ::close(ends[1]);
    char reached = 0;
    EXPECT_EQ(::read(ends[0], &reached, 1), 1);
    ::close(ends[0]);
    ::kill(process, signal);
    int status = 0;
    ::waitpid(process, &status, 0);
    return status;
}

void waitForTheEnd() {
    for (;;)
        ::pause();
}

class StagingTest : public testing::TestWithParam<int> {
  protected:
    TempFolder folder;
};

TEST_P(StagingTest, aFileThatIsWrittenLeavesTheOneBefore) {
    const fs::path file = folder.write("out.txt", "old");
    const int status = endInTheMidst(GetParam(), [&](auto reached) {
        writeWhole(file, [&](const fs::path& partial) {
            std::ofstream stream(partial);
            stream << "half" << std::flush;
            reached();
            waitForTheEnd();
        });
    });
    EXPECT_TRUE(WIFSIGNALED(status));
    EXPECT_EQ(WTERMSIG(status), GetParam());
    EXPECT_EQ(textOf(file), "old");
    EXPECT_THAT(names(folder), ElementsAre("out.txt"));
}

TEST_P(StagingTest, filesThatBelongTogetherLeaveThoseBefore) {
    folder.write("a.txt", "old a");
    folder.write("index.txt", "old index");
    const int status = endInTheMidst(GetParam(), [&](auto reached) {
        const StagedFolder staged(folder.path());
        writeText(staged.path() / "a.txt", "new a");
        writeWhole(staged.path() / "b.txt", [&](const fs::path& partial) {
            std::ofstream(partial) << "half";
            reached();
            waitForTheEnd();
        });
    });
    EXPECT_TRUE(WIFSIGNALED(status));
    EXPECT_EQ(WTERMSIG(status), GetParam());
    EXPECT_EQ(textOf(folder.path() / "a.txt"), "old a");
    EXPECT_EQ(textOf(folder.path() / "index.txt"), "old index");
    EXPECT_THAT(names(folder), UnorderedElementsAre("a.txt", "index.txt"));
}

TEST_P(StagingTest, filesGetTheirNamesAllOrNone) {
    const int status = endInTheMidst(GetParam(), [&](auto reached) {
        const Staging staging(folder.path());
        for (const char* name : {"a", "b"})
            std::ofstream(staging.path() / name) << name;
        Staging::whole([&] {
            fs::rename(staging.path() / "a", folder.path() / "a");
            reached();
            ::usleep(100'000); // so that the signal comes now
            fs::rename(staging.path() / "b", folder.path() / "b");
        });
        waitForTheEnd();
    });
    EXPECT_TRUE(WIFSIGNALED(status));
    EXPECT_EQ(WTERMSIG(status), GetParam());
    EXPECT_THAT(names(folder), UnorderedElementsAre("a", "b"));
}

TEST_P(StagingTest, aSignalThatWasIgnoredStaysSo) {
    const auto write = [&](auto reached) {
        ::raise(GetParam());
        writeText(folder.path() / "a.txt", "all");
        reached();
    };
    const int status = endInTheMidst(SIGURG, write, GetParam()); // SIGURG means nothing
    EXPECT_TRUE(WIFEXITED(status));
    EXPECT_EQ(textOf(folder.path() / "a.txt"), "all");
}

INSTANTIATE_TEST_SUITE_P(Signals, StagingTest, testing::Values(SIGINT, SIGTERM, SIGHUP),
                         [](const auto& test) { return std::string(sigabbrev_np(test.param)); });

TEST(KilledStagingTest, LeavesTheFileBeforeAndHinderNothing) {
    const TempFolder folder;
    const fs::path file = folder.write("out.txt", "old");
    const int status = endInTheMidst(SIGKILL, [&](auto reached) {
        writeWhole(file, [&](const fs::path& partial) {
            std::ofstream(partial) << "half";
            reached();
            waitForTheEnd();
        });
    });
    EXPECT_TRUE(WIFSIGNALED(status));
    EXPECT_EQ(textOf(file), "old");
    // The hidden folder of the dead may be there, even under the number of the living.
    fs::create_directory(folder.path() / (".partial-" + std::to_string(::getpid())));
    writeText(file, "new");
    EXPECT_EQ(textOf(file), "new");
    EXPECT_EQ(names(folder).size(), 3u) << "and what others left is not touched";
}

} // namespace
} // namespace limpid::io
