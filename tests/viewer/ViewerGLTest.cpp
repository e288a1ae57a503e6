// The viewer as its user has it: real mouse and keyboard events go in through an X server, and what comes out
// is what that server's screen shows.
#include <functional>

#include "apps/RunProgram.h"
#include "apps/viewer/Gizmo.h"
#include "io/Images.h"
#include "io/SceneFile.h"
#include "io/TempFolder.h"
#include "viewer/Display.h"
#include "viewer/Drop.h"

namespace limpid::test {
namespace {

constexpr const char* pond = R"(# A ball in a pond.
[camera]
position = [0.9, 1.3, 1.6]
target = [0, -0.3, 0]

[water]
grid = [24, 24]

[[water.wave]]
amplitude = 0.01    # m
wavelength = 0.5
speed = 0.5

[[light]]
name = "sun"
direction = [0.3, -1, 0.1]
irradiance = [3, 3, 3]

[[receiver]]
name = "floor"
plane = { size = [2, 2] }
translation = [0, -0.8, 0]

[[receiver]]            # what it is about
name = "ball"
sphere = { radius = 0.3 }
translation = [0, -0.3, 0]

[caustics]
map_size = 64
)";

/// Small, for software renders it.
constexpr glm::ivec2 screenSize{448, 336};
constexpr const char* shape = "--size 448x336 --interface-scale 0.7";
/// What no panel covers, with the panels that the viewer starts with.
constexpr glm::ivec2 pictureFrom{205, 20}, pictureTo{445, 315};
constexpr glm::ivec2 panelFrom{0, 20}, panelTo{200, 315};
constexpr glm::ivec2 ball{322, 150};

class ViewerGLTest : public ::testing::Test {
  protected:
    void TearDown() override {
        if (_viewer <= 0) return;
        kill(_viewer, SIGTERM);
        waitpid(_viewer, nullptr, 0);
        _viewer = -1;
    }

    void open(const std::string& input, std::vector<std::string> more = {}) {
        ASSERT_FALSE(display.name().empty()) << "Xvfb did not start: install what tools/packages lists";
        std::vector<std::string> words = {LIMPID_BUILD "/limpid", "view", "--verbose", "--size", "448x336",
                                          "--interface-scale",    "0.7"};
        if (!input.empty()) words.push_back(input);
        words.insert(words.end(), more.begin(), more.end());
        _seen = 0;
        _viewer = start(words, output(), display.name(), environment);
    }
    void openPond() {
        open(folder.write("pond.toml", pond).string());
        ASSERT_TRUE(completes());
        display.send(fmt::format("mousemove {} {}", ball.x, ball.y));
        first = screen();
    }

    fs::path output() const { return folder.path() / "viewer.txt"; }
    std::string said() const {
        std::ifstream file(output());
        return {std::istreambuf_iterator<char>(file), {}};
    }
    int completed() const {
        const std::string text = said();
        int count = 0;
        for (std::size_t at = 0; (at = text.find("picture complete", at)) != std::string::npos; ++at)
            ++count;
        return count;
    }
    bool runs() const { return waitpid(_viewer, nullptr, WNOHANG) == 0; }

    /// Whether it becomes true before a slow machine's patience ends.
    static bool until(const std::function<bool()>& is) {
        for (const auto end = Clock::now() + std::chrono::seconds(120); Clock::now() < end;
             std::this_thread::sleep_for(std::chrono::milliseconds(20)))
            if (is()) return true;
        return false;
    }
    bool completes() {
        const bool done = until([&] { return completed() > _seen; });
        _seen = completed();
        return done;
    }
    Screen screen() const { return display.screen(); }
    /// Sends events that change the picture, and waits for all of it.
    void act(const std::string& commands) {
        _seen = completed();
        display.send(commands);
        EXPECT_TRUE(completes()) << commands;
    }
    /// Sends events, and waits for the picture to look different by `share` of its pixels.
    void change(const std::string& commands, double share) {
        const Screen before = screen();
        display.send(commands);
        EXPECT_TRUE(until([&] { return pictureChange(before, screen()) > share; })) << commands;
    }
    double pictureChange(const Screen& a, const Screen& b) const {
        return changed(a, b, pictureFrom, pictureTo);
    }
    /// All pixels but the status bar, which counts frames.
    static double anyChange(const Screen& a, const Screen& b) { return changed(a, b, {0, 0}, {448, 318}); }

    /// Whether a message is over the picture.
    bool isRed() const {
        const glm::ivec3 pixel = screen().at(222, 30);
        return pixel.r > 80 && pixel.g < 60 && pixel.b < 60;
    }
    fs::path savedPicture() const { return folder.path() / "pond-1.png"; }
    fs::path savedScene() const { return folder.path() / "changed.toml"; }
    /// Saves picture and scene; the scene's text.
    std::string saved() {
        for (const fs::path& file : {savedPicture(), savedScene()})
            fs::remove(file);
        display.send("key p");
        EXPECT_TRUE(until([&] { return fs::exists(savedPicture()); }));
        display.send("key ctrl+s sleep 0.5 key ctrl+a");
        display.send(fmt::format("type --delay 1 {}", savedScene().string()));
        display.send("sleep 0.5 key Return");
        EXPECT_TRUE(until([&] { return fs::exists(savedScene()); })) << said();
        std::ifstream stream(savedScene());
        return {std::istreambuf_iterator<char>(stream), {}};
    }
    /// That `limpid render` makes the saved picture of the saved scene.
    void expectRendered(double time) {
        const io::FloatImage shown = io::readImage(savedPicture());
        const fs::path file = folder.path() / "rendered.png";
        const Result result = run(fmt::format("render {} -o {} --size {}x{} --time {}", savedScene().string(),
                                              file.string(), shown.width, shown.height, time));
        ASSERT_EQ(result.code, 0) << result.out;
        const io::FloatImage rendered = io::readImage(file);
        ASSERT_EQ(rendered.data.size(), shown.data.size());
        long most = 0;
        for (std::size_t i = 0; i < shown.data.size(); ++i)
            most = std::max(most, std::lround(255 * std::abs(shown.data[i] - rendered.data[i])));
        // Tone mapping in the GPU's logarithms and the CPU's may fall on either side of a step.
        EXPECT_LE(most, 1);
    }

    TempFolder folder;
    std::map<std::string, std::string> environment;
    Display display{folder.path(), screenSize};
    Screen first;

  private:
    pid_t _viewer = -1;
    int _seen = 0;

  protected:
    int _writes = 1;
};

TEST_F(ViewerGLTest, aDragOrbits) {
    openPond();
    change("mousedown 1 mousemove 300 140 mousemove 260 120 mouseup 1", 0.3);
}

TEST_F(ViewerGLTest, wheelPanAndKeysMoveTheCamera) {
    openPond();
    change("click 4", 0.3);
    change("mousedown 3 mousemove 350 170 mouseup 3", 0.3);
    change("keydown d sleep 0.1 keyup d", 0.3);
    change("key f", 0.3);
    display.send(fmt::format("key Home mousemove {} {}", ball.x, ball.y));
    EXPECT_TRUE(until([&] { return anyChange(first, screen()) == 0; }));
}

TEST_F(ViewerGLTest, questionMarkShowsTheKeys) {
    openPond();
    display.send("key question");
    EXPECT_TRUE(until([&] { return pictureChange(first, screen()) > 0.5; }));
    display.send("key Escape");
    EXPECT_TRUE(until([&] { return anyChange(first, screen()) == 0; }));
}

TEST_F(ViewerGLTest, tabGivesThePictureTheWholeWindow) {
    openPond();
    display.send("key Tab");
    // Nothing is left of the panel.
    EXPECT_TRUE(until([&] { return changed(first, screen(), panelFrom, panelTo) > 0.9; }));
    display.send("key Tab");
    EXPECT_TRUE(until([&] { return anyChange(first, screen()) == 0; }));
}

TEST_F(ViewerGLTest, timePlaysStepsAndStops) {
    openPond();
    change("key period", 0.2);
    display.send("key comma");
    EXPECT_TRUE(until([&] { return anyChange(first, screen()) == 0; }));
    change("key space", 0.2);
    const Screen playing = screen();
    EXPECT_TRUE(until([&] { return pictureChange(playing, screen()) > 0.2; }));
    act("key space");
}

TEST_F(ViewerGLTest, aClickPicksAndShowsFields) {
    openPond();
    display.send(fmt::format("mousemove {} {} click 1", ball.x, ball.y));
    EXPECT_TRUE(until([&] { return changed(first, screen(), panelFrom, panelTo) > 0.02; }));
    EXPECT_GT(pictureChange(first, screen()), 0); // its handles
    display.send("key Escape");
    EXPECT_TRUE(until([&] { return anyChange(first, screen()) == 0; }));
}

TEST_F(ViewerGLTest, aFieldOfThePanelChangesTheScene) {
    openPond();
    // The ball's row, then the middle number of its translation, which is its height.
    display.send(fmt::format("mousemove {} {} click 1", ball.x, ball.y));
    ASSERT_TRUE(until([&] { return changed(first, screen(), panelFrom, panelTo) > 0.02; }));
    change("mousemove 52 121 mousedown 1 mousemove 62 121 mousemove 92 121 mouseup 1", 0.05);
}

TEST_F(ViewerGLTest, wrongFilesAreToldInTheWindow) {
    open((folder.path() / "missing.toml").string());
    EXPECT_TRUE(until([&] { return isRed(); }));
    EXPECT_TRUE(runs());
    // The window goes on, and takes a file that is right.
    const fs::path good = folder.write("pond.toml", pond);
    display.send("mousemove 322 250 key ctrl+o sleep 0.5");
    display.send(fmt::format("type --delay 1 {}", good.string()));
    display.send("sleep 0.5 key Return");
    EXPECT_TRUE(completes()) << said();
    EXPECT_FALSE(isRed());
    // Another wrong one leaves the scene where it is.
    first = screen();
    display.send("key ctrl+o sleep 0.5");
    display.send(fmt::format("type --delay 1 {}", folder.write("odd.toml", "[watr]").string()));
    display.send("sleep 0.5 key Return");
    EXPECT_TRUE(until([&] { return isRed(); }));
    EXPECT_EQ(changed(first, screen(), {205, 120}, {445, 315}), 0);
    EXPECT_TRUE(runs());
}

TEST_F(ViewerGLTest, filesAreDropped) {
    const Screen empty = screen();
    open("");
    ASSERT_TRUE(until([&] { return anyChange(empty, screen()) > 0.01; }));
    Drop drop(display.name());
    EXPECT_TRUE(drop.file(folder.write("pond.toml", pond).string()));
    ASSERT_TRUE(completes()) << said();
    first = screen();
    EXPECT_TRUE(drop.file(folder.write("broken.glb", "glTF, but not really").string()));
    EXPECT_TRUE(until([&] { return isRed(); }));
    EXPECT_EQ(changed(first, screen(), {205, 120}, {445, 315}), 0);
    EXPECT_TRUE(drop.file(folder.path().string())); // a folder
    EXPECT_TRUE(runs());
    display.send("mousemove 322 250 key Escape");
    EXPECT_TRUE(until([&] { return !isRed(); }));
}

TEST_F(ViewerGLTest, aSavedSceneIsThePictureOfRender) {
    openPond();
    change("mousedown 1 mousemove 300 140 mousemove 260 120 mouseup 1", 0.3);
    change("key plus key plus click 4 key period key period", 0.3);
    const std::string text = saved();
    expectRendered(2.0 / 30);
    EXPECT_NE(text.find("[[receiver]]            # what it is about"), std::string::npos) << text;
}

TEST_F(ViewerGLTest, aHandleMovesTheBallAndUndoBringsItBack) {
    const fs::path file = folder.write("pond.toml", pond);
    open(file.string(), {"--select", "ball"});
    ASSERT_TRUE(completes());
    // Where the interface puts things at this size, with letters of 11 pixels.
    const glm::dvec2 corner(202, 15), size(246, 303);
    Scene scene = io::loadScene(file);
    const viewer::Projection projection(scene.camera, scene.water, size);
    const viewer::Gizmo gizmo(scene.receivers[1], glm::dvec3(0), viewer::Gizmo::Mode::Move, projection, 55);
    const auto at = [&](double metres) {
        const glm::ivec2 pixel = glm::round(corner + *projection.pixel(gizmo.at(1, metres)));
        return fmt::format("mousemove {} {} ", pixel.x, pixel.y);
    };
    constexpr double from = 0.12, to = 0.27; // m over the middle
    display.send(at(from));
    // A handle under the mouse turns yellow.
    const auto isYellow = [&] {
        first = screen();
        for (int y = pictureFrom.y; y < pictureTo.y; ++y)
            for (int x = pictureFrom.x; x < pictureTo.x; ++x)
                if (first.at(x, y) == glm::ivec3(255, 225, 90)) return true;
        return false;
    };
    ASSERT_TRUE(until(isYellow));
    change("mousedown 1 " + at(0.5 * (from + to)) + at(to) + "mouseup 1", 0.02);
    saved();
    expectRendered(0);
    const Scene moved = io::loadScene(savedScene());
    const glm::dvec3 way = moved.receivers[1].translation - scene.receivers[1].translation;
    EXPECT_EQ(way.x, 0);
    EXPECT_EQ(way.z, 0);
    // A mouse stands on whole pixels, of 7 mm, which the height is foreshortened to by a half about.
    EXPECT_NEAR(way.y, to - from, 0.02);
    EXPECT_EQ(moved.receivers[0].translation, scene.receivers[0].translation);
    EXPECT_EQ(moved.camera.position, scene.camera.position);
    display.send(at(from) + "key ctrl+z");
    EXPECT_TRUE(until([&] { return pictureChange(first, screen()) == 0; }));
    change("key ctrl+y", 0.02);
}

TEST_F(ViewerGLTest, everyKindOfSceneIsSavedAsItIsShown) {
    const std::string sea = "[water]\ngrid = [24, 24]\n[[water.wave]]\ntype = \"phillips\"\nmodes = 16\n"
                            "amplitude = 0.01\n";
    const std::string rain = "[water]\ngrid = [24, 24]\npreset = \"rain drops\"\nwave_scale = 3\n";
    const std::string depths =
        "[camera]\nposition = [0.9, -0.5, 1.6]\ntarget = [0, -0.3, 0]\n[godrays]\nmethod = \"photon-lines\"\n"
        "grid = [20, 20]\nscale = 0.5\n[water]\ngrid = [24, 24]\ntype = \"coastal\"\npreset = \"breeze\"\n";
    const std::string objects = std::string(pond).substr(std::string(pond).find("[[light]]"));
    for (const auto& [water, method] : {std::pair(sea, "level-map-smart"), std::pair(rain, "photon-splat"),
                                        std::pair(depths, "exact-beam")}) {
        SCOPED_TRACE(water);
        fs::remove(output());
        open(folder.write("pond.toml", water + objects).string(), {"--method", method});
        ASSERT_TRUE(completes());
        display.send("mousemove 322 250");
        change("click 4 key plus key period", 0.3);
        saved();
        expectRendered(1.0 / 30);
        TearDown();
    }
}

TEST_F(ViewerGLTest, boxPlanesAndBeamsAreDrawnOverThePicture) {
    open(folder.write("pond.toml", pond).string(), {"--select", "ball", "--method", "level-map-smart"});
    ASSERT_TRUE(completes());
    for (const char* key : {"b", "g", "r"})
        change(fmt::format("mousemove 322 250 key {}", key), 0.005);
}

TEST_F(ViewerGLTest, twoMethodsStandSideBySide) {
    const std::vector<std::string> planes = {"--method", "level-map", "--planes", "2"};
    display.send("mousemove 300 330"); // the X server draws the arrow into its screen
    open(folder.write("pond.toml", pond).string(), planes);
    ASSERT_TRUE(completes());
    const Screen one = screen();
    TearDown();
    fs::remove(output());
    std::vector<std::string> both = planes;
    both.insert(both.end(), {"--compare", "exact-beam"});
    open((folder.path() / "pond.toml").string(), both);
    ASSERT_TRUE(completes());
    // The left half is as it was, but for the methods' names; two planes are not what the other half is made
    // by.
    const int split = (201 + 448) / 2;
    EXPECT_EQ(changed(one, screen(), {205, 60}, {split - 2, 315}), 0);
    EXPECT_GT(changed(one, screen(), {split + 2, 60}, {445, 315}), 0.1);
}

TEST_F(ViewerGLTest, shadersReloadAndABrokenOneIsTold) {
    const fs::path shaders = folder.path() / "shaders", file = shaders / "viewer/show.frag";
    fs::copy(LIMPID_ROOT "/shaders", shaders, fs::copy_options::recursive);
    environment["LIMPID_SHADERS"] = shaders.string();
    openPond();
    const auto write = [&](const std::string& text) {
        std::ofstream(file) << text;
        // A file's time may be coarser than this test is quick.
        fs::last_write_time(file, fs::file_time_type::clock::now() + std::chrono::seconds(_writes++));
    };
    const auto isGreen = [&] { return screen().at(322, 200) == glm::ivec3(0, 255, 0); };
    const std::string green =
        "layout(location = 0) out vec4 shown;\nvoid main() { shown = vec4(0, 1, 0, 1); }\n";
    write(green);
    EXPECT_TRUE(until(isGreen));
    write(green + "oops");
    EXPECT_TRUE(until([&] { return isRed(); }));
    EXPECT_TRUE(isGreen());
    std::ifstream whole(LIMPID_ROOT "/shaders/viewer/show.frag");
    write({std::istreambuf_iterator<char>(whole), {}});
    EXPECT_TRUE(until([&] { return changed(first, screen(), {205, 60}, {445, 315}) == 0; }));
}

TEST_F(ViewerGLTest, aSequenceIsRecorded) {
    openPond();
    display.send("key v");
    const fs::path frames = folder.path() / "pond-1-frames";
    ASSERT_TRUE(until([&] { return fs::exists(frames / "0001.png"); }));
    display.send("key v");
    const Result result = run(fmt::format("compare {0}/0000.png {0}/0001.png --max-nmae 0", frames.string()));
    EXPECT_EQ(result.code, 1) << result.out; // they differ
}

TEST_F(ViewerGLTest, screenshotTakesTheWindowAndLeaves) {
    const fs::path scene = folder.write("pond.toml", pond), file = folder.path() / "window.png";
    const Result result =
        run(fmt::format("view {} {} --screenshot {} --after-frames 3", scene.string(), shape, file.string()),
            fmt::format("DISPLAY={}", display.name()));
    EXPECT_EQ(result.code, 0) << result.out;
    const io::FloatImage shot = io::readImage(file);
    EXPECT_EQ(shot.width, screenSize.x);
    EXPECT_EQ(shot.height, screenSize.y);
    // Panel on the left, picture on the right: two colours and many.
    openPond();
    display.send("mousemove 300 330"); // the X server draws the arrow into its screen
    ASSERT_TRUE(until([&] { return anyChange(first, screen()) > 0; }));
    first = screen();
    int different = 0;
    for (int y = 0; y < 318; ++y)
        for (int x = 0; x < 448; ++x)
            for (int c = 0; c < 3; ++c)
                different +=
                    std::lround(255 * shot.data[std::size_t(3 * (y * 448 + x) + c)]) != first.at(x, y)[c];
    EXPECT_EQ(different, 0);
}

TEST(ViewerWithoutDisplay, leavesWithOneLine) {
    const Result result = run("view " LIMPID_ROOT "/models/teapot.glb", "env -u DISPLAY -u WAYLAND_DISPLAY");
    EXPECT_EQ(result.code, 3);
    EXPECT_TRUE(result.out.starts_with("limpid: no display to open a window on")) << result.out;
    EXPECT_EQ(std::count(result.out.begin(), result.out.end(), '\n'), 1) << result.out;
}

} // namespace
} // namespace limpid::test
