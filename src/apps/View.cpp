#include <chrono>

#include "apps/Common.h"
#include "apps/EngineUse.h"
#include "core/Error.h"
#include "io/Outputs.h"
#include <fmt/format.h>

#ifdef LIMPID_WITH_VIEWER
#include "apps/viewer/Viewer.h"

namespace limpid::apps {

namespace {

struct ViewOptions {
    CommonOptions common;
    viewer::Options viewer;
    std::string size = "1280x720";
    std::string screenshot;
    std::string compare;
};

void view(ViewOptions& options, std::chrono::steady_clock::time_point begin) {
    viewer::Options& viewer = options.viewer;
    if (!options.common.device.empty())
        throw InputError(
            "--device: a window is drawn by the GPU of its display; expected no device with limpid view");
    requireTime(viewer.time);
    viewer.begin = begin;
    viewer.size = parseSize(options.size);
    viewer.file = options.common.input;
    viewer.load = [&] { return loadDocument(options.common); };
    viewer.screenshot = options.screenshot;
    if (!options.screenshot.empty()) io::requireOutput(options.screenshot);
    viewer.compare = methodFromName(options.compare);
    if (!options.compare.empty() && !viewer.compare)
        throw InputError(
            fmt::format("--compare: expected the name of a method, found \"{}\"", options.compare));
    viewer.gpuMemory = contextOptions(options.common).memory;
    viewer.noSkip = options.common.noSkip;
    viewer.verbose = options.common.verbose;
    viewer::show(viewer);
}

} // namespace

void addView(CLI::App& app) {
    const auto begin = std::chrono::steady_clock::now();
    auto* command = app.add_subcommand("view", "the interactive viewer: ? in its window shows the keys");
    command->footer(
        "Examples:\n  limpid view fish.glb\n  limpid view scene.toml --select fish --panel understand");
    auto options = std::make_shared<ViewOptions>();
    addCommonOptions(*command, options->common);
    command->get_option("INPUT")->required(false);
    command->add_option("--size", options->size, "pixels of the window, WxH")->capture_default_str();
    command->add_option("--time", options->viewer.time, "seconds");
    command->add_flag("--play", options->viewer.play, "the water moves from the start");
    command
        ->add_option("--interface-scale", options->viewer.interfaceScale,
                     "size of text and controls; 1 is that of a plain display")
        ->check(CLI::Range(0.5, 4.0));
    command->add_option("--panel", options->viewer.panel, "opens a panel: measure, understand, compare")
        ->check(CLI::IsMember({"measure", "understand", "compare"}));
    command->add_option("--select", options->viewer.select, "picks a receiver by name");
    command->add_option("--compare", options->compare, "a second method, beside the first");
    auto* screenshot =
        command->add_option("--screenshot", options->screenshot,
                            "takes the window's picture, interface included, to this .png, and leaves");
    command
        ->add_option("--after-frames", options->viewer.afterFrames,
                     "frames with a complete picture before the screenshot")
        ->needs(screenshot)
        ->check(CLI::Range(1, 1000000))
        ->capture_default_str();
    command->callback([options, begin] { view(*options, begin); });
}

} // namespace limpid::apps

#else

namespace limpid::apps {

void addView(CLI::App& app) {
    auto* command = app.add_subcommand("view", "the interactive viewer, which this build does not have");
    command->allow_extras();
    command->callback([] {
        throw InputError(
            "view: this build has no viewer; build with -DLIMPID_VIEWER=ON, or use limpid render");
    });
}

} // namespace limpid::apps

#endif
