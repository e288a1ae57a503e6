#include "apps/Common.h"

#include <charconv>
#include <cmath>
#include <cstdlib>

#include <fmt/format.h>
#include <unistd.h>

#include "core/Error.h"
#include "io/Files.h"
#include "scene/Keys.h"

namespace limpid::apps {

void addCommonOptions(CLI::App& command, CommonOptions& options) {
    command.add_option("INPUT", options.input, "scene (.toml) or model (.glb, .gltf)")->required();
    const auto add = [&](const char* name, auto& value, const auto& key) {
        const Choice* choice = std::get_if<Choice>(&key.takes);
        command.add_option(name, value,
                           choice ? fmt::format("{}: {}", key.says, fmt::join(choice->names, ", "))
                                  : std::string(key.says));
    };
    add("--method", options.method, keyOf(causticsKeys, &CausticsSettings::method));
    add("--fill", options.fill, keyOf(causticsKeys, &CausticsSettings::fill));
    add("--godrays", options.godrays, keyOf(godrayKeys, &GodraySettings::method));
    add("--planes", options.planes, keyOf(causticsKeys, &CausticsSettings::planes));
    add("--map-size", options.mapSize, keyOf(causticsKeys, &CausticsSettings::mapSize));
    command
        .add_option("--set", options.settings,
                    "KEY=VALUE: change any key of the scene, see limpid man (repeatable)")
        ->allow_extra_args(false)
        ->take_all();
    command
        .add_option("--without", options.without,
                    "PATTERN: leave nodes, meshes and materials of that name out of a model, such as "
                    "\"Water*\" (repeatable)")
        ->allow_extra_args(false)
        ->take_all();
    command.add_flag("--no-skip", options.noSkip,
                     "do all work that skipping would save; the result is the same");
    command.add_option("--device", options.device,
                       "EGL device, by number or part of its name (see limpid info)");
    command
        .add_option("--gpu-memory", options.gpuMemory,
                    "MiB of GPU memory at the most; what needs more ends with exit code 3")
        ->check(CLI::Range(1.0, 1e9));
    command.add_flag("--quiet", options.quiet, "print errors only");
    command.add_flag("--verbose", options.verbose, "print times, planes and memory");
}

io::SceneDocument loadDocument(const CommonOptions& options) {
    std::vector<io::Override> overrides;
    for (const std::string& setting : options.settings) {
        const std::size_t equals = setting.find('=');
        if (equals == std::string::npos || equals == 0)
            throw InputError(fmt::format("--set: expected KEY=VALUE, found \"{}\"", setting));
        overrides.push_back({setting.substr(0, equals), setting.substr(equals + 1)});
    }
    if (!options.method.empty()) overrides.push_back({"caustics.method", options.method});
    if (!options.fill.empty()) overrides.push_back({"caustics.fill", options.fill});
    if (!options.godrays.empty()) overrides.push_back({"godrays.method", options.godrays});
    if (options.planes) overrides.push_back({"caustics.planes", std::to_string(*options.planes)});
    if (options.mapSize) overrides.push_back({"caustics.map_size", std::to_string(*options.mapSize)});
    if (!options.without.empty() && !io::isModelFile(options.input))
        throw InputError(
            fmt::format("--without: expected a model (.glb, .gltf) as input, found {}; in a scene it "
                        "is a receiver's key, without = [\"{}\"]",
                        io::oneLine(options.input), io::oneLine(options.without.front())));
    if (!options.without.empty()) overrides.push_back(io::leavingOut(options.without));
    return io::SceneDocument(options.input, overrides);
}

Scene loadScene(const CommonOptions& options) {
    return loadDocument(options).scene();
}

void requireTime(double seconds) {
    if (!(std::abs(seconds) <= 1e9))
        throw InputError(fmt::format("--time: expected seconds from -1e9 to 1e9, found {}", seconds));
}

glm::ivec2 parseSize(const std::string& text) {
    glm::ivec2 size(0);
    const char* end = text.data() + text.size();
    const auto width = std::from_chars(text.data(), end, size.x);
    if (width.ec == std::errc() && width.ptr != end && *width.ptr == 'x') {
        const auto height = std::from_chars(width.ptr + 1, end, size.y);
        if (height.ec == std::errc() && height.ptr == end && size.x >= 1 && size.y >= 1 && size.x <= 7680 &&
            size.y <= 7680)
            return size;
    }
    throw InputError(fmt::format("--size: expected WxH with 1 to 7680 pixels each, found \"{}\"", text));
}

void printFlux(const io::Bake& bake) {
    for (const io::BakedLight& light : bake.lights) {
        if (!light.flux) continue;
        const io::BakedFlux& flux = *light.flux;
        const auto percent = [&](double watts) {
            return flux.entering > 0 ? 100 * watts / flux.entering : 0.0;
        };
        const std::string error =
            flux.standardError ? fmt::format(", give or take {:.3f}", percent(*flux.standardError)) : "";
        fmt::print(
            "{}: {:.6g} W enter; {:.6g} deposited, {:.6g} absorbed, {:.6g} scattered, {:.6g} missed, {:.6g} "
            "rejected; residual {:.3g} ({:.3f} %{})\n",
            light.light, flux.entering, flux.deposited, flux.absorbed, flux.scattered, flux.missed,
            flux.rejected, flux.residual, percent(flux.residual), error);
    }
}

bool onPath(const std::string& program) {
    const char* path = std::getenv("PATH");
    std::string_view rest = path ? path : "";
    while (!rest.empty()) {
        const std::string_view folder = rest.substr(0, rest.find(':'));
        if (access(fmt::format("{}/{}", folder, program).c_str(), X_OK) == 0) return true;
        rest.remove_prefix(std::min(rest.size(), folder.size() + 1));
    }
    return false;
}

} // namespace limpid::apps
