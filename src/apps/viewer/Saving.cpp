#include "apps/viewer/Saving.h"

#include <fmt/format.h>

#include "core/Error.h"
#include "io/Files.h"
#include "io/images/Images.h"

namespace fs = std::filesystem;

namespace limpid::viewer {

namespace {

/// The first of STEM-1, STEM-2, … that is free.
fs::path freeName(const fs::path& scene, const char* suffix) {
    for (int i = 1;; ++i)
        if (const fs::path name = fmt::format("{}-{}{}", scene.stem().string(), i, suffix); !fs::exists(name))
            return name;
}

void writeDisplay(const Display& display, const fs::path& file) {
    const glm::ivec2 size = display.picture().size();
    io::writePng(file, size.x, size.y, display.pixels());
}

} // namespace

std::string proposedScene(const fs::path& file) {
    return io::lowerCaseSuffix(file) == ".toml" ? file.string() : file.stem().string() + ".toml";
}

void saveScene(const io::SceneDocument& document, const Scene& scene, const fs::path& file) {
    if (io::lowerCaseSuffix(file) != ".toml")
        throw InputError(fmt::format("{}: expected a name that ends in .toml", file.string()));
    const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
    io::writeText(file, document.textOf(scene, folder));
}

fs::path savePicture(const Display& display, const fs::path& scene) {
    const fs::path file = freeName(scene, ".png");
    writeDisplay(display, file);
    return file;
}

Recorder::Recorder(const fs::path& scene, double time) : _folder(freeName(scene, "-frames")), _begin(time) {
    std::error_code error;
    if (!fs::create_directory(_folder, error))
        throw InputError(fmt::format("{}: cannot make this folder for the pictures: {}", _folder.string(),
                                     error.message()));
}

void Recorder::add(const Display& display) {
    writeDisplay(display, _folder / fmt::format("{:04d}.png", _count));
    ++_count;
}

std::string Recorder::summary() const {
    return fmt::format("{}: {} frames, {} a second", _folder.string(), _count, framesPerSecond);
}

} // namespace limpid::viewer
