#include <filesystem>
#include <optional>

#include <fmt/format.h>
#include <unistd.h>

#include "apps/Common.h"
#include "apps/Frames.h"
#include "core/Error.h"
#include "core/Progress.h"
#include "engine/Engine.h"
#include "io/Images.h"

namespace limpid::apps {

namespace {

struct RenderOptions {
    CommonOptions common;
    std::string output;
    std::string size = "960x540";
    double time = 0;
    std::string frames;
    double fps = 30;
};

void write(const std::filesystem::path& file, const Picture& picture, double exposure) {
    if (file.extension() == ".exr")
        io::writeExr(file, picture.size.x, picture.size.y, {"R", "G", "B"}, picture.rgb);
    else
        io::writePng(file, picture.size.x, picture.size.y, toneMapped(picture, exposure));
}

void requirePictureName(const std::filesystem::path& file, bool sequence) {
    if (file.extension() != ".png" && file.extension() != ".exr" && !(sequence && isVideo(file)))
        throw InputError(fmt::format("{}: expected a name that ends in .png or .exr{}, found \"{}\"",
                                     file.string(), sequence ? ", or .mp4, .mkv or .webm" : "",
                                     file.extension().string()));
    const auto folder = file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
    if (std::filesystem::is_directory(folder) && access(folder.c_str(), W_OK) != 0)
        throw InputError(fmt::format("{}: expected a folder to write to, found {} closed to writing",
                                     file.string(), folder.string()));
    if (!std::filesystem::is_directory(folder))
        throw InputError(fmt::format("{}: expected a folder to write to, found none named {}", file.string(),
                                     folder.string()));
}

/// Frame i is at time i / fps. Pictures that are there already are kept, so that an interrupted sequence goes
/// on.
void renderFrames(const RenderOptions& options, Engine& engine, glm::ivec2 size, double exposure) {
    const FrameRange range = parseFrames(options.frames);
    std::optional<VideoWriter> video;
    if (isVideo(options.output)) video.emplace(options.output, size, options.fps);
    Progress progress("frames", range.count(), !options.common.quiet);
    int kept = 0;
    for (int frame = range.first; frame <= range.last; ++frame) {
        progress.update(frame - range.first);
        const auto file = video ? std::filesystem::path() : frameName(options.output, frame);
        if (!video && std::filesystem::exists(file)) {
            ++kept;
            continue;
        }
        const Picture picture = engine.render(frame / options.fps, size);
        if (video)
            video->add(toneMapped(picture, exposure).data());
        else
            write(file, picture, exposure);
    }
    if (video) video->finish();
    if (options.common.quiet) return;
    fmt::print("{}: {} frames of {} x {} pixels", options.output, range.count(), size.x, size.y);
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
    const double exposure = scene.camera.exposure;
    gl::Context context(contextOptions(options.common));
    if (const int most = Engine::largestPicture(context); std::max(size.x, size.y) > most)
        throw InputError(fmt::format(
            "--size: expected at most {} pixels on a side with this GPU, found \"{}\"", most, options.size));
    Engine engine(context);
    engine.setSkipping(!options.common.noSkip);
    engine.setScene(std::move(scene));
    printWarnings(engine, options.common);
    if (sequence) {
        renderFrames(options, engine, size, exposure);
        return;
    }
    write(options.output, engine.render(options.time, size), exposure);
    if (!options.common.quiet) fmt::print("{}: {} x {} pixels\n", options.output, size.x, size.y);
    if (options.common.verbose) printWork(engine, context);
}

} // namespace

void addRender(CLI::App& app) {
    auto* command = app.add_subcommand("render", "a picture: tone-mapped .png or linear .exr");
    command->footer("Examples:\n  limpid render fish.glb -o fish.png --set light.sun.direction=[0.9,-1,0]\n  "
                    "limpid render scene.toml -o f%04d.png --frames 0..99 --fps 25");
    auto options = std::make_shared<RenderOptions>();
    addCommonOptions(*command, options->common);
    command->add_option("-o,--output", options->output, "picture to write, .png or .exr")->required();
    command->add_option("--size", options->size, "pixels, WxH")->capture_default_str();
    auto* time = command->add_option("--time", options->time, "seconds");
    command
        ->add_option("--frames", options->frames,
                     "A..B: a sequence; the picture's name holds %04d, or ends in .mp4")
        ->excludes(time);
    command->add_option("--fps", options->fps, "frames a second")
        ->check(CLI::Range(1e-3, 1e6))
        ->capture_default_str();
    command->callback([options] { render(*options); });
}

} // namespace limpid::apps
