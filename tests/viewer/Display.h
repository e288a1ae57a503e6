#pragma once
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

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

/// An Xvfb, as long as this lives.
class Display {
  public:
    Display(const fs::path& folder, glm::ivec2 size) : _folder(folder) {
        int ends[2];
        if (pipe(ends) != 0) return;
        _server =
            start({"Xvfb", "-displayfd", std::to_string(ends[1]), "-screen", "0",
                   fmt::format("{}x{}x24", size.x, size.y), "-fbdir", folder.string(), "-nolisten", "tcp"},
                  folder / "Xvfb.txt");
        close(ends[1]);
        char text[16] = {};
        if (read(ends[0], text, sizeof(text) - 1) > 0) _name = fmt::format(":{}", std::atoi(text));
        close(ends[0]);
    }
    ~Display() {
        if (_server <= 0) return;
        kill(_server, SIGTERM);
        waitpid(_server, nullptr, 0);
    }
    Display(const Display&) = delete;
    Display& operator=(const Display&) = delete;

    const std::string& name() const { return _name; } ///< empty if there is none

    /// The X server keeps it as an X window dump: a header of big-endian words, a table of colours, and rows
    /// of blue, green, red and a byte of padding.
    Screen screen() const {
        std::ifstream file(_folder / "Xvfb_screen0", std::ios::binary);
        const std::vector<std::uint8_t> bytes{std::istreambuf_iterator<char>(file), {}};
        const auto word = [&](std::size_t i) {
            return std::size_t(bytes[4 * i]) << 24 | std::size_t(bytes[4 * i + 1]) << 16 |
                   std::size_t(bytes[4 * i + 2]) << 8 | std::size_t(bytes[4 * i + 3]);
        };
        Screen screen{{int(word(4)), int(word(5))}, {}};
        const std::size_t pixels = word(0) + 12 * word(19), row = word(12);
        for (std::size_t y = 0; y < word(5); ++y)
            for (std::size_t x = 0; x < word(4); ++x)
                for (const std::size_t c : {2, 1, 0})
                    screen.rgb.push_back(bytes[pixels + y * row + 4 * x + c]);
        return screen;
    }

    /// What xdotool takes; the events go through the server as those of a real mouse and keyboard do.
    void send(const std::string& commands) const {
        const std::string line = fmt::format("DISPLAY={} xdotool {}", _name, commands);
        EXPECT_EQ(std::system(line.c_str()), 0) << line;
    }

  private:
    fs::path _folder;
    pid_t _server = -1;
    std::string _name;
};

} // namespace limpid::test
