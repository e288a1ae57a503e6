#pragma once
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>
#include <xcb/xcb.h>

#include <glm/glm.hpp>

/// A display of a test's own, what is on it, and mouse and keyboard events on their way through the X server.
namespace limpid::test {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

/// What a display shows: RGB, rows from the top.
struct Screen {
    glm::ivec2 size{0};
    std::vector<std::uint8_t> rgb;

    bool operator==(const Screen&) const = default;
    glm::ivec3 at(int x, int y) const {
        const std::size_t i = 3 * (std::size_t(y) * std::size_t(size.x) + std::size_t(x));
        return {rgb[i], rgb[i + 1], rgb[i + 2]};
    }
};

/// Share of the pixels of a rectangle that differ.
inline double changed(const Screen& a, const Screen& b, glm::ivec2 from, glm::ivec2 to) {
    int count = 0;
    for (int y = from.y; y < to.y; ++y)
        for (int x = from.x; x < to.x; ++x)
            count += a.at(x, y) != b.at(x, y);
    const glm::ivec2 size = to - from;
    return double(count) / (size.x * size.y);
}

/// Runs a program in the background, in the folder of its output's file.
inline pid_t start(const std::vector<std::string>& words, const fs::path& output,
                   const std::string& display = "",
                   const std::map<std::string, std::string>& environment = {}) {
    const pid_t process = fork();
    if (process != 0) return process;
    const int file = open(output.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
    dup2(file, STDOUT_FILENO);
    dup2(file, STDERR_FILENO);
    if (chdir(output.parent_path().c_str()) != 0) _exit(126);
    if (!display.empty()) setenv("DISPLAY", display.c_str(), 1);
    for (const auto& [name, value] : environment)
        setenv(name.c_str(), value.c_str(), 1);
    std::vector<char*> arguments;
    for (const std::string& word : words)
        arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    execvp(arguments[0], arguments.data());
    _exit(127);
}

template <typename T>
using Owned = std::unique_ptr<T, decltype(&std::free)>;
/// A reply of the X server, which its reader frees.
template <typename T>
Owned<T> owned(T* reply) {
    return Owned<T>(reply, &std::free);
}

/// An Xvfb, as long as this lives.
class Display {
  public:
    Display(const fs::path& folder, glm::ivec2 size) {
        int ends[2];
        if (pipe(ends) != 0) return;
        _server = start({"Xvfb", "-displayfd", std::to_string(ends[1]), "-screen", "0",
                         fmt::format("{}x{}x24", size.x, size.y), "-nolisten", "tcp"},
                        folder / "Xvfb.txt");
        close(ends[1]);
        char text[16] = {};
        if (read(ends[0], text, sizeof(text) - 1) > 0) _name = fmt::format(":{}", std::atoi(text));
        close(ends[0]);
        _connection = xcb_connect(_name.c_str(), nullptr);
    }
    ~Display() {
        xcb_disconnect(_connection);
        if (_server <= 0) return;
        kill(_server, SIGTERM);
        waitpid(_server, nullptr, 0);
    }
    Display(const Display&) = delete;
    Display& operator=(const Display&) = delete;

    const std::string& name() const { return _name; } ///< empty if there is none

    /// Asked of the X server, which answers between two drawings and leaves out the mouse's arrow. Its own
    /// memory (-fbdir) would be read in the middle of one: half a frame, and the arrow now there, now not.
    Screen screen() const {
        if (xcb_connection_has_error(_connection)) throw std::runtime_error("no X server to ask");
        const xcb_screen_t& root = *xcb_setup_roots_iterator(xcb_get_setup(_connection)).data;
        const glm::ivec2 size(root.width_in_pixels, root.height_in_pixels);
        const auto cookie = xcb_get_image(_connection, XCB_IMAGE_FORMAT_Z_PIXMAP, root.root, 0, 0,
                                          root.width_in_pixels, root.height_in_pixels, ~0u);
        const auto image = owned(xcb_get_image_reply(_connection, cookie, nullptr));
        if (!image) throw std::runtime_error("the X server gives no image of its screen");
        // Blue, green, red and a byte of padding.
        const std::uint8_t* pixels = xcb_get_image_data(image.get());
        Screen screen{size, {}};
        screen.rgb.reserve(std::size_t(3 * size.x * size.y));
        for (int i = 0; i < size.x * size.y; ++i)
            for (const int c : {2, 1, 0})
                screen.rgb.push_back(pixels[4 * i + c]);
        return screen;
    }

    /// What xdotool takes; the events go through the server as those of a real mouse and keyboard do.
    void send(const std::string& commands) const {
        const std::string line = fmt::format("DISPLAY={} xdotool {}", _name, commands);
        EXPECT_EQ(std::system(line.c_str()), 0) << line;
    }

  private:
    pid_t _server = -1;
    std::string _name;
    xcb_connection_t* _connection = nullptr;
};

} // namespace limpid::test
