#include <chrono>
#include <filesystem>

#include <fmt/format.h>

#include "apps/Common.h"
#include "core/Error.h"
#include "engine/Engine.h"
#include "io/Images.h"

namespace limpid::apps {

namespace {

struct RenderOptions {
    CommonOptions common;
    std::string output;
    std::string size = "960x540";
    double time = 0;
};

void write(const std::filesystem::path& file, const Picture& picture, double exposure) {
    if (file.extension() == ".exr")
        io::writeExr(file, picture.size.x, picture.size.y, {"R", "G", "B"}, picture.rgb);
    else
        io::writePng(file, picture.size.x, picture.size.y, toneMapped(picture, exposure));
}

void requirePictureName(const std::filesystem::path& file) {
    if (file.extension() != ".png" && file.extension() != ".exr")
        throw InputError(fmt::format("{}: expected a name that ends in .png or .exr, found \"{}\"",
                                     file.string(), file.extension().string()));
    const auto folder = file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
    if (!std::filesystem::is_directory(folder))
        throw InputError(fmt::format("{}: expected a folder to write to, found none named {}", file.string(),
                                     folder.string()));
}

void render(const RenderOptions& options) {
    const glm::ivec2 size = parseSize(options.size);
    requirePictureName(options.output);
    Scene scene = loadScene(options.common);
    const double exposure = scene.camera.exposure;
    gl::Context context(contextOptions(options.common));
    Engine engine(context);
    engine.setSkipping(!options.common.noSkip);
    engine.setScene(std::move(scene));
    write(options.output, engine.render(options.time, size), exposure);
    if (!options.common.quiet) fmt::print("{}: {} x {} pixels\n", options.output, size.x, size.y);
    if (options.common.verbose) printWork(engine, context);
}

} // namespace

void addRender(CLI::App& app) {
    auto* command = app.add_subcommand("render", "a picture: tone-mapped .png or linear .exr");
    auto options = std::make_shared<RenderOptions>();
    addCommonOptions(*command, options->common);
    command->add_option("-o,--output", options->output, "picture to write, .png or .exr")->required();
    command->add_option("--size", options->size, "pixels, WxH")->capture_default_str();
    command->add_option("--time", options->time, "seconds");
    command->callback([options] { render(*options); });
}

} // namespace limpid::apps
