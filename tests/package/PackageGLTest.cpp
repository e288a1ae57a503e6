// What cmake --install leaves: headers that need no others of ours, packages that are found, and examples
// that build and run with nothing but that.
#include <algorithm>
#include <set>

#include <gmock/gmock.h>

#include "io/TempFolder.h"
#include "io/images/Images.h"
#include "viewer/Display.h"

namespace limpid {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

struct Ran {
    int code = -1;
    std::string out; ///< stdout and stderr
};

Ran run(const std::string& command) {
    Ran ran;
    FILE* pipe = popen(fmt::format("{} 2>&1", command).c_str(), "r");
    char buffer[4096];
    while (const std::size_t bytes = std::fread(buffer, 1, sizeof(buffer), pipe))
        ran.out.append(buffer, bytes);
    ran.code = WEXITSTATUS(pclose(pipe));
    return ran;
}

class PackageGLTest : public ::testing::Test {
  protected:
    /// Installed, then moved: nothing in it may name where it was.
    static void SetUpTestSuite() {
        _folder = std::make_unique<test::TempFolder>();
        const fs::path first = _folder->path() / "first";
        const Ran ran =
            run(fmt::format("{} --install {} --prefix {}", CMAKE_PROGRAM, LIMPID_BUILD, first.string()));
        ASSERT_EQ(ran.code, 0) << ran.out;
        fs::rename(first, prefix());
    }
    static void TearDownTestSuite() { _folder.reset(); }

    static fs::path prefix() { return _folder->path() / "installed"; }

    static std::set<std::string> filesBelow(const fs::path& folder) {
        std::set<std::string> files;
        for (const auto& entry : fs::recursive_directory_iterator(folder))
            if (entry.is_regular_file()) files.insert(fs::relative(entry.path(), folder).string());
        return files;
    }

    /// Configures and builds an example with what is installed; the folder that its program lies in.
    static fs::path build(const std::string& example) {
        const fs::path folder = _folder->path() / example;
        const Ran ran = run(fmt::format("{0} -S {1}/examples/{2} -B {3} -G Ninja -DCMAKE_BUILD_TYPE=Release "
                                        "-DCMAKE_CXX_COMPILER={4} -DCMAKE_CXX_FLAGS='-Wall -Wextra -Werror' "
                                        "-DCMAKE_PREFIX_PATH={5} && {0} --build {3}",
                                        CMAKE_PROGRAM, LIMPID_ROOT, example, folder.string(), CXX_COMPILER,
                                        prefix().string()));
        EXPECT_EQ(ran.code, 0) << ran.out;
        return folder;
    }

    static inline std::unique_ptr<test::TempFolder> _folder;
};

TEST_F(PackageGLTest, everyHeaderCompilesByItself) {
    const fs::path include = prefix() / "include";
    int count = 0;
    for (const std::string& header : filesBelow(include)) {
        SCOPED_TRACE(header);
        EXPECT_TRUE(header.starts_with("limpid/"));
        ++count;
        const Ran ran = run(fmt::format("{} -std=c++20 -Wall -Wextra -Wpedantic -Werror -I {} -include {} "
                                        "-fsyntax-only -MD -MF /dev/stdout -x c++ /dev/null",
                                        CXX_COMPILER, include.string(), header));
        EXPECT_EQ(ran.code, 0) << ran.out;
        EXPECT_THAT(ran.out, HasSubstr(header));
        for (const char* foreign : {"epoxy", "OpenImageIO", "/EGL/", "/fmt/", LIMPID_ROOT})
            EXPECT_EQ(ran.out.find(foreign), std::string::npos) << foreign;
    }
    EXPECT_GE(count, 15);
}

TEST_F(PackageGLTest, holdsProgramManualCompletionLicenceAndShader) {
    const std::set<std::string> files = filesBelow(prefix());
    for (const char* file :
         {"bin/limpid", "share/man/man1/limpid.1", "share/bash-completion/completions/limpid",
          "share/doc/limpid/LICENSE", "share/limpid/shaders/limpid_caustics.glsl"})
        EXPECT_TRUE(files.contains(file)) << file;
    const Ran version = run((prefix() / "bin/limpid").string() + " --version");
    EXPECT_THAT(version.out, HasSubstr(LIMPID_VERSION));
    EXPECT_EQ(run("bash -n " + (prefix() / "share/bash-completion/completions/limpid").string()).code, 0);
}

TEST_F(PackageGLTest, aSceneBecomesAnExrWithoutADisplay) {
    const fs::path folder = build("headless");
    const Ran ran = run(fmt::format("env -u DISPLAY {0}/headless {1}/models/box.glb {0}/box.exr",
                                    folder.string(), LIMPID_ROOT));
    EXPECT_EQ(ran.code, 0) << ran.out;
    const io::FloatImage image = io::readImage(folder / "box.exr");
    EXPECT_EQ(image.channels, 3);
    EXPECT_GT(*std::max_element(image.data.begin(), image.data.end()), 0.5f);
    const Ran missing = run(fmt::format("{0}/headless no.toml {0}/no.exr", folder.string()));
    EXPECT_EQ(missing.code, 1);
    EXPECT_EQ(std::count(missing.out.begin(), missing.out.end(), '\n'), 1) << missing.out;
}

TEST_F(PackageGLTest, theViewersWindowOpensInAnotherProgram) {
    const fs::path project = _folder->path() / "window";
    _folder->write("window/CMakeLists.txt", "cmake_minimum_required(VERSION 3.25)\n"
                                            "project(window LANGUAGES CXX)\n"
                                            "find_package(limpid REQUIRED COMPONENTS viewer)\n"
                                            "add_executable(window Main.cpp)\n"
                                            "target_link_libraries(window PRIVATE limpid::viewer)\n");
    _folder->write("window/Main.cpp", R"(#include <limpid/viewer/Viewer.h>
int main(int, char** arguments) {
    limpid::viewer::Options options;
    options.begin = std::chrono::steady_clock::now();
    options.file = arguments[1];
    options.load = [&] { return limpid::io::SceneDocument(arguments[1]); };
    options.size = {320, 240};
    options.screenshot = arguments[2];
    limpid::viewer::show(options);
}
)");
    const Ran built =
        run(fmt::format("{0} -S {1} -B {1}/build -G Ninja -DCMAKE_BUILD_TYPE=Release "
                        "-DCMAKE_CXX_COMPILER={2} -DCMAKE_PREFIX_PATH={3} && {0} --build {1}/build",
                        CMAKE_PROGRAM, project.string(), CXX_COMPILER, prefix().string()));
    ASSERT_EQ(built.code, 0) << built.out;
    const test::Display display(_folder->path(), {640, 480});
    const Ran ran = run(fmt::format("DISPLAY={0} {1}/build/window {2}/models/box.glb {1}/window.png",
                                    display.name(), project.string(), LIMPID_ROOT));
    EXPECT_EQ(ran.code, 0) << ran.out;
    const io::FloatImage image = io::readImage(project / "window.png");
    EXPECT_EQ(image.width, 320);
    EXPECT_EQ(image.height, 240);
}

/// Mean of red over a square of a picture, [0, 1].
double meanAround(const io::FloatImage& image, int x, int y) {
    double sum = 0;
    for (int j = y - 4; j < y + 4; ++j)
        for (int i = x - 4; i < x + 4; ++i)
            sum += double(image.data[std::size_t(image.channels * (j * image.width + i))]);
    return sum / 64;
}

TEST_F(PackageGLTest, aHostsOwnRendererShowsCausticsAndShade) {
    const fs::path folder = build("embed-glfw");
    const test::Display display(_folder->path(), {1024, 600});
    const Ran ran = run(fmt::format("DISPLAY={0} {1}/embed-glfw --frames 2 --screenshot {1}/pool.png",
                                    display.name(), folder.string()));
    EXPECT_EQ(ran.code, 0) << ran.out;
    const io::FloatImage image = io::readImage(folder / "pool.png");
    ASSERT_EQ(image.width, 960);
    ASSERT_EQ(image.height, 540);
    double least = 1, most = 0, sum = 0;
    for (int x = 40; x < 920; x += 8) { // over the floor, before the knot
        const double here = meanAround(image, x, 500);
        least = std::min(least, here), most = std::max(most, here), sum += here;
    }
    EXPECT_GT(most, 0.85);              // a caustic's line
    EXPECT_LT(least, 0.7);              // between two of them
    EXPECT_NEAR(sum / 110, 0.72, 0.06); // a floor of albedo 0.75 in 4 W/m², by the host's tone curve
    EXPECT_LT(meanAround(image, 460, 400), 0.35); // in the knot's shade
    EXPECT_GT(meanAround(image, 362, 270), 0.55); // on the knot
}

TEST_F(PackageGLTest, aHostWithoutADisplaySaysSoInOneLine) {
    const fs::path program = _folder->path() / "embed-glfw" / "embed-glfw";
    if (!fs::exists(program)) build("embed-glfw");
    const Ran ran = run("env -u DISPLAY -u WAYLAND_DISPLAY " + program.string());
    EXPECT_EQ(ran.code, 1);
    EXPECT_THAT(ran.out, HasSubstr("embed-glfw: GLFW: "));
    EXPECT_EQ(std::count(ran.out.begin(), ran.out.end(), '\n'), 1) << ran.out;
}

TEST_F(PackageGLTest, pkgConfigSaysHowToLink) {
    const fs::path pc = [] {
        for (const auto& entry : fs::recursive_directory_iterator(prefix()))
            if (entry.path().filename() == "limpid-io.pc") return entry.path().parent_path();
        return fs::path();
    }();
    const Ran ran = run(fmt::format("PKG_CONFIG_PATH={0} && export PKG_CONFIG_PATH && {1} -std=c++20 "
                                    "{2}/examples/headless/Main.cpp -o {3}/by-pkg-config "
                                    "$(pkg-config --cflags --libs limpid-io)",
                                    pc.string(), CXX_COMPILER, LIMPID_ROOT, _folder->path().string()));
    EXPECT_EQ(ran.code, 0) << ran.out;
}

TEST_F(PackageGLTest, anUnknownComponentIsNamed) {
    const fs::path project =
        _folder->write("asks/CMakeLists.txt", "cmake_minimum_required(VERSION 3.25)\n"
                                              "project(asks LANGUAGES CXX)\n"
                                              "find_package(limpid REQUIRED COMPONENTS tea)\n");
    const Ran ran = run(fmt::format("{0} -S {1} -B {1}/build -G Ninja -DCMAKE_PREFIX_PATH={2}", CMAKE_PROGRAM,
                                    project.parent_path().string(), prefix().string()));
    EXPECT_NE(ran.code, 0);
    EXPECT_THAT(ran.out, HasSubstr("expected components out of"));
    EXPECT_THAT(ran.out, HasSubstr("got tea"));
}

} // namespace
} // namespace limpid
