// Caustics in a program that has a window, a renderer and a render loop of its own:
// embed-glfw [--frames N] [--screenshot OUT.png]
#include <charconv>
#include <exception>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include <limpid/Caustics.h>

#include "Pool.h"
#include "Water.h"
#include "Window.h"

namespace {

struct Options {
    std::optional<int> frames; ///< none: until the window is closed
    std::string screenshot;    ///< of the last frame; empty for none
};

int wholeNumber(const std::string& text) {
    int number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size() || number < 1)
        throw limpid::InputError("--frames: expected a number >= 1, got " + text);
    return number;
}

Options parse(const std::vector<std::string>& words) {
    Options options;
    for (std::size_t i = 0; i < words.size(); i += 2) {
        if (i + 1 < words.size() && words[i] == "--frames")
            options.frames = wholeNumber(words[i + 1]);
        else if (i + 1 < words.size() && words[i] == "--screenshot")
            options.screenshot = words[i + 1];
        else
            throw limpid::InputError("usage: embed-glfw [--frames N] [--screenshot OUT.png]");
    }
    if (!options.screenshot.empty() && !options.frames) options.frames = 1;
    return options;
}

void run(const Options& options) {
    Window window({960, 540}, "Limpid embedded");
    const Pool pool;
    const Water water;
    limpid::Caustics caustics(limpid::Context::current());
    caustics.set(pool.scene(water.wave()));
    bool open = true;
    for (int frame = 0; open; ++frame) {
        const double seconds = options.frames ? frame / 30.0 : window.seconds();
        water.move(seconds);
        caustics.update(seconds);
        pool.draw(caustics.maps(), window.size());
        const bool last = options.frames && frame + 1 == *options.frames;
        if (last && !options.screenshot.empty()) window.save(options.screenshot);
        open = window.show() && !last;
    }
}

} // namespace

int main(int count, char** words) try {
    run(parse({words + 1, words + count}));
} catch (const std::exception& error) {
    std::cerr << "embed-glfw: " << error.what() << '\n';
    return 1;
}
