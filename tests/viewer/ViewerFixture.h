#pragma once
// The viewer as its user has it: real mouse and keyboard events go in through an X server, and what comes out
// is what that server's screen shows.
#include <functional>

#include "apps/RunProgram.h"
#include "io/TempFolder.h"
#include "io/images/Images.h"
#include "viewer/Display.h"

namespace limpid::test {

inline constexpr const char* pond = R"(# A ball in a pond.
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
inline constexpr glm::ivec2 screenSize{448, 336};
inline constexpr const char* shape = "--size 448x336 --interface-scale 0.7";
/// What no panel covers, with the panels that the viewer starts with.
inline constexpr glm::ivec2 pictureFrom{205, 20}, pictureTo{445, 315};
inline constexpr glm::ivec2 panelFrom{0, 20}, panelTo{200, 315};
inline constexpr glm::ivec2 ball{322, 150};

class ViewerFixture : public ::testing::Test {
  protected:
    void TearDown() override {
        if (_viewer <= 0) return;
        kill(_viewer, SIGTERM);
        waitpid(_viewer, nullptr, 0);
        _viewer = -1;
    }

    void open(const std::string& input, std::vector<std::string> more = {}) {
        ASSERT_FALSE(display.name().empty()) << "Xvfb did not start: install what tools/packages lists";
        std::vector<std::string> words = {test::buildFolder() + "/limpid",
                                          "view",
                                          "--verbose",
                                          "--size",
                                          "448x336",
                                          "--interface-scale",
                                          "0.7"};
        if (!input.empty()) words.push_back(input);
        words.insert(words.end(), more.begin(), more.end());
        _seen = 0;
        _viewer = start(words, output(), display.name(), environment);
    }
    void openPond() {
        open(folder.write("pond.toml", pond).string());
        if (!completes()) throw std::runtime_error("no complete picture of the pond: " + said());
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

    /// Waits for the window to look as it did at first.
    void expectFirstAgain() const {
        const auto change = [&] { return anyChange(first, screen()); };
        EXPECT_TRUE(until([&] { return change() == 0; })) << change() << " of the pixels differ\n" << said();
    }

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

} // namespace limpid::test
