// What the shell and man are told, and what a slip of the pen is answered with.
#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "apps/RunProgram.h"
#include "io/TempFolder.h"
#include "scene/Keys.h"

namespace limpid::test {
namespace {

using ::testing::HasSubstr;

constexpr const char* commands[] = {"render", "view", "bake", "compare", "profile", "info"};

/// What bash offers for the last of `words`.
std::string completions(const std::string& words, int number) {
    const TempFolder folder;
    const std::string script = folder.write("limpid.bash", run("completion").out).string();
    FILE* pipe = popen(fmt::format("bash -c 'source {}; COMP_WORDS=({}); COMP_CWORD={}; _limpid; "
                                   "echo ${{COMPREPLY[@]}}'",
                                   script, words, number)
                           .c_str(),
                       "r");
    if (!pipe) return "";
    char buffer[4096] = {};
    const std::size_t bytes = std::fread(buffer, 1, sizeof(buffer) - 1, pipe);
    pclose(pipe);
    return std::string(buffer, bytes);
}

TEST(ShellCommand, bashCompletesCommandsOptionsAndMethods) {
    for (const char* command : commands)
        EXPECT_THAT(completions("limpid \"\"", 1), HasSubstr(command));
    EXPECT_EQ(completions("limpid rend", 1), "render\n");
    EXPECT_EQ(completions("limpid render --map", 2), "--map-size\n");
    EXPECT_EQ(completions("limpid bake --method exa", 3), "exact-beam\n");
    EXPECT_EQ(completions("limpid bake --fill one", 3), "one-pass\n");
    EXPECT_EQ(completions("limpid view --panel und", 3), "understand\n");
    EXPECT_EQ(completions("limpid render --godrays photon", 3), "photon-lines\n");
    EXPECT_EQ(completions("limpid render --set water.le", 3), "water.level=\n");
    EXPECT_EQ(completions("limpid render --set light.0.dir", 3), "light.0.direction=\n");
    EXPECT_EQ(completions("limpid render --set receiver.0.with", 3), "receiver.0.without=\n");
    EXPECT_EQ(completions("limpid render --godrays exa", 3), "exact-shafts\n");
    EXPECT_EQ(completions("limpid render --godrays tet", 3), "tetrahedra\n");
}

TEST(ShellCommand, theManualPageHasEveryCommandAndOption) {
    const Result page = run("man");
    EXPECT_EQ(page.code, 0);
    EXPECT_TRUE(page.out.starts_with(".TH LIMPID 1")) << page.out.substr(0, 80);
    for (const char* command : commands)
        EXPECT_THAT(page.out, HasSubstr(fmt::format(".SS {}\n", command)));
    EXPECT_THAT(page.out, HasSubstr("\\-\\-after\\-frames"));
    EXPECT_THAT(page.out, HasSubstr(".SH EXIT STATUS\n"));
    EXPECT_THAT(page.out, HasSubstr("\\fBcaustics.method\\fR\n\"exact\\-beam\"\n"));
}

TEST(ShellCommand, theManualPageAndBashHaveEveryKey) {
    const std::string page = run("man").out, offered = completions("limpid render --set \"\"", 3);
    std::string keys = page.substr(page.find(".SH SCENE KEYS"));
    keys.resize(keys.find(".SH EXIT STATUS"));
    std::size_t listed = 0;
    for (std::size_t at = 0; (at = keys.find(".TP\n", at)) != std::string::npos; ++at)
        ++listed;
    EXPECT_EQ(listed, sceneKeys().size());
    EXPECT_EQ(std::size_t(std::count(offered.begin(), offered.end(), '=')), sceneKeys().size());
    for (const KeyFacts& key : sceneKeys()) {
        EXPECT_THAT(keys, HasSubstr(fmt::format("\\fB{}\\fR\n", key.path())));
        EXPECT_THAT(offered, HasSubstr(key.path() + '='));
    }
}

TEST(ShellCommand, aSlipIsAnsweredWithTheNearestName) {
    const Result command = run("rendr fish.glb");
    EXPECT_EQ(command.code, 2);
    EXPECT_THAT(command.out, HasSubstr("found \"rendr\", did you mean \"render\"?"));
    const Result option = run("info --jsn");
    EXPECT_EQ(option.code, 2);
    EXPECT_THAT(option.out, HasSubstr("did you mean \"--json\"?"));
}

TEST(ShellCommand, helpHasExamples) {
    for (const char* command : commands)
        EXPECT_THAT(run(fmt::format("{} --help", command)).out,
                    HasSubstr(fmt::format("limpid {} ", command)));
}

} // namespace
} // namespace limpid::test
