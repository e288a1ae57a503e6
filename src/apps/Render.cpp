#include <filesystem>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "apps/Common.h"
#include "apps/EngineUse.h"
#include "apps/Frames.h"
#include "core/Error.h"
#include "core/Progress.h"
#include "engine/Engine.h"
#include "io/Files.h"
#include "io/Outputs.h"
#include "io/images/Images.h"

namespace limpid::apps {

namespace {

struct RenderOptions {
    CommonOptions common;
    std::string output;
    std::string size = "960x540";
    double time = 0;
    std::string frames;
    double fps = 30;
    bool overwrite = false;
};

void write(const std::filesystem::path& file, Engine& engine, double time, glm::ivec2 size,
           const std::string& fingerprint = "") {
    if (io::lowerCaseSuffix(file) == ".exr")
        io::writeExr(file, size.x, size.y, {"R", "G", "B"}, engine.render(time, size).rgb, fingerprint);
    else
        io::writePng(file, size.x, size.y, engine.renderToneMapped(time, size), fingerprint);
}

/// Throws InputError unless pictures can be written under that name. Pipes and devices need no suffix.
void requirePictureName(const std::filesystem::path& file, bool sequence) {
    const std::string suffix = io::lowerCaseSuffix(file);
    const bool picture = suffix == ".png" || suffix == ".exr" || io::outputOf(file).isStream();
    if (!picture && !(sequence && isVideo(file)))
        throw InputError(fmt::format("{}: expected a name that ends in .png or .exr{}, found \"{}\"",
                                     file.string(), sequence ? ", or .mp4, .mkv or .webm" : "",
                                     file.extension().string()));
    io::requireOutput(file);
}

/// For reports: stdout unless the picture may go there.
std::FILE* reportStream(const RenderOptions& options) {
    return io::outputOf(options.output).isStream() ? stderr : stdout;
}

void renderVideo(const RenderOptions& options, Engine& engine, glm::ivec2 size) {
    const FrameRange range = parseFrames(options.frames);
    VideoWriter video(options.output, size, options.fps);
    Progress progress("frames", range.count(), !options.common.quiet);
    for (int frame = range.first; frame <= range.last; ++frame) {
        progress.update(frame - range.first);
        video.add(engine.renderToneMapped(frame / options.fps, size).data());
    }
    video.finish();
    if (!options.common.quiet)
        fmt::print("{}: {} frames of {} x {} pixels\n", options.output, range.count(), size.x, size.y);
}

/// Numbers of the frames whose pictures are not there yet.
std::vector<int> missingFrames(const RenderOptions& options, const FrameSequence& sequence) {
    const FrameRange range = parseFrames(options.frames);
    std::vector<int> missing;
    for (int frame = range.first; frame <= range.last; ++frame)
        if (!sequence.isThere(frame, options.overwrite)) missing.push_back(frame);
    for (const int frame : missing)
        io::requireOutput(sequence.file(frame));
    return missing;
}

void renderFrames(const RenderOptions& options, Engine& engine, const FrameSequence& sequence,
                  const std::vector<int>& frames, glm::ivec2 size) {
    const int count = parseFrames(options.frames).count(), kept = count - int(frames.size());
    Progress progress("frames", count, !options.common.quiet);
    for (std::size_t i = 0; i < frames.size(); ++i) {
        progress.update(kept + int(i));
        write(sequence.file(frames[i]), engine, frames[i] / options.fps, size,
              sequence.fingerprint(frames[i]));
    }
    if (options.common.quiet) return;
    fmt::print("{}: {} frames of {} x {} pixels", options.output, count, size.x, size.y);
    if (kept > 0) fmt::print(", {} of them there already", kept);
    fmt::print("\n");
}

void render(const RenderOptions& options) {
    const glm::ivec2 size = parseSize(options.size);
    requireTime(options.time);
    const bool sequence = !options.frames.empty();
    requirePictureName(options.output, sequence);
    if (sequence && !isVideo(options.output)) frameName(options.output, parseFrames(options.frames).first);
    Scene scene = loadScene(options.common);
    std::optional<FrameSequence> frames; // a video is written anew
    if (sequence && !isVideo(options.output)) frames.emplace(scene, options.output, size, options.fps);
    const std::vector<int> missing = frames ? missingFrames(options, *frames) : std::vector<int>();
    gl::Context context(contextOptions(options.common));
    if (const int most = Engine::largestPicture(context); std::max(size.x, size.y) > most)
        throw InputError(fmt::format(
            "--size: expected at most {} pixels on a side with this GPU, found \"{}\"", most, options.size));
    Engine engine(context);
    engine.setSkipping(!options.common.noSkip);
    engine.set(std::move(scene));
    printWarnings(engine, options.common);
    if (frames) {
        renderFrames(options, engine, *frames, missing, size);
        return;
    }
    if (sequence) {
        renderVideo(options, engine, size);
        return;
    }
    write(options.output, engine, options.time, size);
    if (!options.common.quiet)
        fmt::print(reportStream(options), "{}: {} x {} pixels\n", options.output, size.x, size.y);
    if (options.common.verbose) printWork(engine, context, reportStream(options));
}

} // namespace

void addRender(CLI::App& app) {
    auto* command = app.add_subcommand("render", "a picture: tone-mapped .png or linear .exr");
    command->footer("Examples:\n  limpid render fish.glb -o fish.png --set light.sun.direction=[0.9,-1,0]\n  "
                    "limpid render scene.toml -o f%04d.png --frames 0..99 --fps 25");
    auto options = std::make_shared<RenderOptions>();
    addCommonOptions(*command, options->common);
    command
        ->add_option("-o,--output", options->output,
                     "picture to write, .png or .exr; a pipe or device gets a PNG")
        ->required();
    command->add_option("--size", options->size, "pixels, WxH")->capture_default_str();
    auto* time = command->add_option("--time", options->time, "seconds");
    command
        ->add_option("--frames", options->frames,
                     "A..B: a sequence; the picture's name holds %04d, or ends in .mp4")
        ->excludes(time);
    command->add_flag("--overwrite", options->overwrite,
                      "replace frames of another scene or size, in place of an error");
    command->add_option("--fps", options->fps, "frames a second")
        ->check(CLI::Range(1e-3, 1e6))
        ->capture_default_str();
    command->callback([options] { render(*options); });
}

} // namespace limpid::apps
