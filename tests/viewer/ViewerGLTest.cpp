#include "Folders.h"
#include "viewer/Drop.h"
#include "viewer/ViewerFixture.h"

namespace limpid::test {
namespace {

using ViewerGLTest = ViewerFixture;

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
    expectFirstAgain();
}

TEST_F(ViewerGLTest, questionMarkShowsTheKeys) {
    openPond();
    display.send("key question");
    EXPECT_TRUE(until([&] { return pictureChange(first, screen()) > 0.5; }));
    display.send("key Escape");
    expectFirstAgain();
}

TEST_F(ViewerGLTest, tabGivesThePictureTheWholeWindow) {
    openPond();
    display.send("key Tab");
    // Nothing is left of the panel.
    EXPECT_TRUE(until([&] { return changed(first, screen(), panelFrom, panelTo) > 0.9; }));
    display.send("key Tab");
    expectFirstAgain();
}

TEST_F(ViewerGLTest, timePlaysStepsAndStops) {
    openPond();
    change("key period", 0.2);
    display.send("key comma");
    expectFirstAgain();
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
    expectFirstAgain();
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

TEST_F(ViewerGLTest, boxPlanesAndBeamsAreDrawnOverThePicture) {
    open(folder.write("pond.toml", pond).string(), {"--select", "ball", "--method", "level-map-smart"});
    ASSERT_TRUE(completes());
    for (const char* key : {"b", "g", "r"})
        change(fmt::format("mousemove 322 250 key {}", key), 0.005);
}

TEST_F(ViewerGLTest, twoMethodsStandSideBySide) {
    const std::vector<std::string> planes = {"--method", "level-map", "--planes", "2"};
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
    fs::copy(test::rootFolder() + "/shaders", shaders, fs::copy_options::recursive);
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
    std::ifstream whole(test::rootFolder() + "/shaders/viewer/show.frag");
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
    int different = 0;
    for (int y = 0; y < 318; ++y)
        for (int x = 0; x < 448; ++x)
            for (int c = 0; c < 3; ++c)
                different +=
                    std::lround(255 * shot.data[std::size_t(3 * (y * 448 + x) + c)]) != first.at(x, y)[c];
    EXPECT_EQ(different, 0);
}

TEST(ViewerWithoutDisplay, leavesWithOneLine) {
    const Result result =
        run("view " + test::rootFolder() + "/models/teapot.glb", "env -u DISPLAY -u WAYLAND_DISPLAY");
    EXPECT_EQ(result.code, 3);
    EXPECT_TRUE(result.out.starts_with("limpid: no display to open a window on")) << result.out;
    EXPECT_EQ(std::count(result.out.begin(), result.out.end(), '\n'), 1) << result.out;
}

} // namespace
} // namespace limpid::test
