#include "io/Outputs.h"

#include <fstream>
#include <sstream>

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "io/Files.h"
#include "io/TempFolder.h"

namespace limpid::io {
namespace {

namespace fs = std::filesystem;
using test::errorOf;
using test::TempFolder;
using testing::HasSubstr;

std::string contentOf(const fs::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

std::ptrdiff_t entriesIn(const fs::path& folder) {
    return std::distance(fs::directory_iterator(folder), {});
}

TEST(OutputsTest, ALinkStaysAndItsFileIsWritten) {
    const TempFolder folder;
    fs::create_directory(folder.path() / "elsewhere");
    const fs::path file = folder.write("elsewhere/real.txt", "old"), link = folder.path() / "link.txt";
    fs::create_symlink("elsewhere/real.txt", folder.path() / "further.txt");
    fs::create_symlink("further.txt", link);
    writeText(link, "new");
    EXPECT_TRUE(fs::is_symlink(link));
    EXPECT_EQ(contentOf(file), "new");
    EXPECT_EQ(entriesIn(folder.path()), 3) << "nothing beside them";
}

TEST(OutputsTest, ALinkToNoFileYetMakesIt) {
    const TempFolder folder;
    fs::create_symlink(folder.path() / "later.txt", folder.path() / "link.txt");
    writeText(folder.path() / "link.txt", "new");
    EXPECT_TRUE(fs::is_symlink(folder.path() / "link.txt"));
    EXPECT_EQ(contentOf(folder.path() / "later.txt"), "new");
}

TEST(OutputsTest, LinksInACircleAreAnError) {
    const TempFolder folder;
    fs::create_symlink("b.txt", folder.path() / "a.txt");
    fs::create_symlink("a.txt", folder.path() / "b.txt");
    EXPECT_EQ(errorOf(folder, [&] { writeText(folder.path() / "a.txt", "new"); }),
              "a.txt: cannot write: it is a link in a circle");
}

TEST(OutputsTest, AnOldFileKeepsItsMode) {
    const TempFolder folder;
    const fs::path file = folder.write("secret.txt", "old");
    fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write);
    writeText(file, "new");
    EXPECT_EQ(contentOf(file), "new");
    EXPECT_EQ(fs::status(file).permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

TEST(OutputsTest, WhatCannotBeWrittenIsTold) {
    const TempFolder folder;
    fs::create_directory(folder.path() / "pictures.png");
    fs::create_symlink("pictures.png", folder.path() / "link.png");
    for (const char* name : {"pictures.png", "link.png", "."})
        EXPECT_THAT(errorOf(folder, [&] { requireOutput(folder.path() / name); }),
                    HasSubstr("expected a file to write to, found a folder"))
            << name;
    EXPECT_THAT(errorOf(folder, [&] { requireOutput(folder.path() / "none/a.png"); }),
                HasSubstr("expected a folder to write to, found none named "));
    EXPECT_EQ(errorOf(folder, [&] { requireOutput(folder.path() / "a.png"); }), "no error");
    EXPECT_EQ(entriesIn(folder.path()), 2) << "a question leaves nothing behind";
}

TEST(OutputsTest, DevicesTakeWhatIsWrittenAndStay) {
    writeText("/dev/null", "anything");
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
    EXPECT_TRUE(outputOf("/dev/null").isStream());
    EXPECT_FALSE(outputOf("a.png").isStream());
}

TEST(OutputsTest, APipeGetsAllBytesOnceTheyAreThere) {
    const TempFolder folder;
    const fs::path pipe = folder.path() / "pipe.txt";
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    const int reader = ::open(pipe.c_str(), O_RDONLY | O_NONBLOCK);
    ASSERT_GE(reader, 0);
    writeText(pipe, "through");
    char text[16] = {};
    EXPECT_EQ(::read(reader, text, sizeof text), 7);
    EXPECT_STREQ(text, "through");
    ::close(reader);
    EXPECT_TRUE(fs::is_fifo(pipe));
}

/// As of a shell's `>> log`: opened by its name, it would be cut off.
TEST(OutputsTest, AnOpenFileIsAddedToWhereItStands) {
    const TempFolder folder;
    const fs::path file = folder.write("log.txt", "before ");
    const int opened = ::open(file.c_str(), O_WRONLY | O_APPEND);
    ASSERT_GE(opened, 0);
    writeText("/dev/fd/" + std::to_string(opened), "after");
    ::close(opened);
    EXPECT_EQ(contentOf(file), "before after");
    EXPECT_EQ(outputOf("/dev/stdout").descriptor, 1);
    EXPECT_EQ(outputOf("/dev/stderr").descriptor, 2);
    EXPECT_EQ(outputOf("/proc/self/fd/1").descriptor, 1);
}

} // namespace
} // namespace limpid::io
