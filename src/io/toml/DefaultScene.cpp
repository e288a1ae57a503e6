#include "io/toml/DefaultScene.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>
#include <set>
#include <string>

#include <fmt/format.h>

#include "core/Tau.h"
#include "io/Files.h"
#include "io/toml/SceneParser.h"
#include "scene/Basin.h"
#include "scene/Scene.h"

namespace limpid::io {

namespace {

// The look of a model alone. Lengths are fractions of its largest extent s, or of its basin's depth d, so
// that it does not depend on size.
constexpr double floorSize = 6.5;        ///< over s
constexpr int mapSize = 1024;            ///< what is lit is several times as wide as what is looked at
constexpr double floorGap = 1e-4;        ///< over s; keeps a flat base and the floor from being one surface
constexpr double waterAbove = 0.6;       ///< over s
constexpr double leastAbove = 0.2;       ///< over s; where the file's camera is low
constexpr double freeboard = 0.08;       ///< over a full basin's deepest water, from level to rim
constexpr double surfaceCover = 0.04;    ///< likewise, from the author's own water surface to the level
constexpr double cameraClearance = 0.15; ///< over the depth; waves are a quarter as high
constexpr double lowestView = 15;        ///< degrees; flatter, the surface is a mirror
constexpr glm::dvec3 absorption{0.3, 0.07, 0.035};  ///< over s or d
constexpr glm::dvec3 scattering{0.02, 0.03, 0.035}; ///< over s or d
constexpr glm::dvec3 sunDirection{0.4, -1, -0.35};  ///< away from the camera, so that what it sees is lit
constexpr glm::dvec3 sunIrradiance{6, 5.8, 5.4};
constexpr glm::dvec3 ambientRadiance{0.16, 0.22, 0.26};

/// A light from lower than this above the horizon hardly gets into the water.
constexpr double lowestSun = 10; ///< degrees
/// Every light costs maps of its own for every receiver; what files have more is fill light for a studio.
constexpr std::size_t mostLights = 8;

struct CosineWave {
    double wavelength;
    double amplitude;
    glm::dvec2 direction;
    double phase;
};
// Over the depth. Light through a crest of curvature c comes together n / ((n - 1) c) below it: through the
// sum of these, 4.3 over the depth, at 0.94 of it.
constexpr CosineWave cosineWaves[] = {{0.55, 0.011, {1, 0.3}, 0}, {0.34, 0.006, {-0.4, 1}, 60}};
constexpr double noiseWavelength = 0.6;
constexpr double noiseAmplitude = 0.012;
constexpr int noiseOctaves = 2;
constexpr double mostWaves = 50;    ///< wave scales across; more are finer than a picture's pixels
constexpr double quadsPerWave = 20; ///< quads in a wave scale, six in the shortest wave
constexpr double mostAmplitude = 2; ///< times that of waves in proportion to the depth

/// The water of a model alone, m.
struct WaterBody {
    double level; ///< y
    double depth; ///< over what caustics are to show on
    double width; ///< of what is lit
    double look;  ///< what absorption and scattering are over

    double waveScale() const { return std::max(depth, width / mostWaves); }
    /// As steep as focuses light at the depth; what is too long for that is not to run over the rim.
    double amplitudeScale() const {
        return std::min(waveScale() * waveScale() / depth, mostAmplitude * depth);
    }
    int grid() const {
        const double quads = std::clamp(quadsPerWave * width / waveScale(), 256.0, 1024.0);
        return int(std::bit_ceil(unsigned(std::lround(quads))));
    }
};

toml::array array(const glm::dvec3& v) {
    return toml::array{v.x, v.y, v.z};
}
toml::array array(const glm::dvec2& v) {
    return toml::array{v.x, v.y};
}

/// Of a gravity wave on deep water, m/s.
double waveSpeed(double wavelength) {
    return std::sqrt(9.81 * wavelength / tau);
}

toml::array waves(const WaterBody& water) {
    const double length = water.waveScale(), height = water.amplitudeScale();
    toml::array result;
    for (const CosineWave& wave : cosineWaves)
        result.push_back(toml::table{{"type", "cosine"},
                                     {"wavelength", wave.wavelength * length},
                                     {"amplitude", wave.amplitude * height},
                                     {"direction", array(wave.direction)},
                                     {"phase", wave.phase},
                                     {"speed", waveSpeed(wave.wavelength * length)}});
    result.push_back(toml::table{{"type", "noise"},
                                 {"wavelength", noiseWavelength * length},
                                 {"amplitude", noiseAmplitude * height},
                                 {"octaves", noiseOctaves},
                                 {"speed", waveSpeed(noiseWavelength * length)}});
    return result;
}

toml::table waterTable(const WaterBody& water) {
    return toml::table{{"level", water.level},
                       {"grid", toml::array{water.grid(), water.grid()}},
                       {"absorption", array(absorption / water.look)},
                       {"scattering", array(scattering / water.look)},
                       {"wave", waves(water)}};
}

/// With everything that names may not hold replaced; empty if that leaves nothing.
std::string cleanName(const std::string& text) {
    std::string name = text.substr(0, 100);
    for (char& c : name)
        if (!isName(std::string(1, c)) && c != '.') c = '_';
    return name.find_first_not_of("_.") == std::string::npos || !isName(name) ? "" : name;
}

/// The file's stem; "model" if that leaves nothing, or the floor's name.
std::string receiverName(const std::filesystem::path& model) {
    const std::string name = cleanName(model.stem().string());
    return name.empty() || name == "floor" ? "model" : name;
}

bool entersWater(const Light& light, double level) {
    if (light.isSpot()) {
        const double axis = std::asin(light.direction.y / glm::length(light.direction));
        if (glm::degrees(axis) - light.outerCone > -lowestSun) return false; // its lowest ray
    }
    if (light.type == LightType::Point) return light.position.y > level;
    return -light.direction.y > std::sin(glm::radians(lowestSun)) * glm::length(light.direction);
}

toml::table lightTable(const Light& light, const std::string& name) {
    if (light.type == LightType::Point) {
        toml::table pointLight{{"name", name},
                               {"type", "point"},
                               {"position", array(light.position)},
                               {"intensity", array(light.intensity)}};
        if (!light.isSpot()) return pointLight;
        pointLight.insert_or_assign("type", "spot");
        pointLight.insert("direction", array(light.direction));
        pointLight.insert("inner_cone", light.innerCone);
        pointLight.insert("outer_cone", light.outerCone);
        return pointLight;
    }
    return toml::table{
        {"name", name}, {"direction", array(light.direction)}, {"irradiance", array(light.irradiance)}};
}

/// The model's lights that get into the water, else a sun.
toml::array lights(const Model& model, double level) {
    toml::array result;
    std::set<std::string> taken;
    for (const Light& light : model.lights) {
        if (!entersWater(light, level) || result.size() == mostLights) continue;
        std::string name = cleanName(light.name);
        // Receivers' names and a dot in front of it must not make it another pair's.
        std::replace(name.begin(), name.end(), '.', '_');
        if (name.empty() || taken.contains(name)) name = fmt::format("light{}", result.size());
        while (!taken.insert(name).second)
            name += '_';
        result.push_back(lightTable(light, name));
    }
    if (!result.empty()) return result;
    Light sun;
    sun.direction = glm::normalize(sunDirection);
    sun.irradiance = sunIrradiance;
    return toml::array{lightTable(sun, "sun")};
}

/// Whether the camera has the middle of the model in view, from above the floor.
bool seesModel(const Camera& camera, const Bounds& bounds) {
    const glm::dvec3 axis = *camera.target - *camera.position;
    const glm::dvec3 way = bounds.center() - *camera.position;
    const double along = glm::dot(way, axis) / glm::length(axis);
    const double across = std::sqrt(std::max(glm::dot(way, way) - along * along, 0.0));
    return camera.position->y > bounds.min.y && along > 0 &&
           across < along * std::tan(0.5 * glm::radians(camera.verticalFov));
}

/// Whether the camera is clear of a basin's waves: above them, or in its water.
bool clearOfWaves(const Camera& camera, const WaterBody& water, const Basin& basin) {
    const double above = camera.position->y - water.level;
    const glm::dvec2 at(camera.position->x, camera.position->z);
    const bool inside = glm::all(glm::greaterThan(at, glm::dvec2(basin.water.min.x, basin.water.min.z))) &&
                        glm::all(glm::lessThan(at, glm::dvec2(basin.water.max.x, basin.water.max.z)));
    return (inside ? std::abs(above) : above) > cameraClearance * water.depth;
}

/// The level over a sunken model: such that `camera`, if there is one, looks down through the surface, or
/// where it is too low for that, is in the water.
double levelOver(const Bounds& bounds, double s, const Camera* camera) {
    const double usual = bounds.max.y + waterAbove * s;
    if (!camera) return usual;
    const glm::dvec3 way = bounds.center() - *camera->position;
    const double across = std::hypot(way.x, way.z), y = camera->position->y;
    const double clear = cameraClearance * (usual - bounds.min.y);
    const double highest = y - std::max(clear, across * std::tan(glm::radians(lowestView)));
    if (highest >= bounds.max.y + leastAbove * s) return std::min(usual, highest);
    return std::max(usual, y + clear);
}

/// The water in a basin of a model `width` m wide.
WaterBody waterIn(const Basin& basin, double width) {
    const double deepest = basin.water.max.y - basin.water.min.y;
    const double level =
        basin.surface ? *basin.surface + surfaceCover * deepest : basin.water.max.y - freeboard * deepest;
    const double depth = std::max(basin.depth - (basin.water.max.y - level), 0.1 * basin.depth);
    return {level, depth, width, depth};
}

toml::table cameraTable(const Camera& camera) {
    return toml::table{{"position", array(*camera.position)},
                       {"target", array(*camera.target)},
                       {"up", array(camera.up)},
                       {"vertical_fov", camera.verticalFov}};
}

toml::table floorTable(const Bounds& bounds, double s) {
    const glm::dvec3 center = bounds.center();
    return toml::table{{"name", "floor"},
                       {"plane", toml::table{{"size", array(glm::dvec2(floorSize * s))}}},
                       {"translation", array(glm::dvec3(center.x, bounds.min.y - floorGap * s, center.z))}};
}

} // namespace

toml::table defaultScene(const std::filesystem::path& file, const Model& model) {
    Bounds bounds;
    for (const glm::dvec3& p : model.mesh.positions)
        bounds.add(p);
    const glm::dvec3 size = bounds.size();
    const double extent = std::max({size.x, size.y, size.z});
    // A model of no size still needs a floor and waves of some; below a micrometre nothing is to be seen.
    const double s = extent > 1e-6 ? extent : 1.0;
    const Camera* camera = model.cameras.empty() ? nullptr : &model.cameras.front();
    if (camera && !seesModel(*camera, bounds)) camera = nullptr;
    toml::array receivers{
        toml::table{{"name", receiverName(file)}, {"gltf", std::filesystem::absolute(file).string()}}};
    WaterBody water{};
    if (const std::optional<Basin> basin = findBasin(model.mesh)) {
        water = waterIn(*basin, std::max(size.x, size.z));
        if (camera && !clearOfWaves(*camera, water, *basin)) camera = nullptr;
    } else {
        const double level = levelOver(bounds, s, camera);
        // In deeper water waves would be too long to show on the model.
        water = {level, std::min(level - bounds.min.y, s), floorSize * s, s};
        receivers.push_back(floorTable(bounds, s));
    }
    toml::table scene{{"water", waterTable(water)},
                      {"light", lights(model, water.level)},
                      {"receiver", receivers},
                      {"caustics", toml::table{{"map_size", mapSize}}},
                      {"ambient", toml::table{{"radiance", array(ambientRadiance)}}}};
    if (camera) scene.insert("camera", cameraTable(*camera));
    return scene;
}

std::vector<std::string> unusedViews(const std::filesystem::path& file, const Model& model,
                                     const toml::table& scene) {
    const double level = scene["water"]["level"].value_or(0.0);
    std::vector<std::string> notices;
    const auto add = [&](const char* kind, const std::string& name, const char* reason) {
        notices.push_back(
            fmt::format("{}: {}: not used: {} ({})", oneLine(file.string()), kind,
                        name.empty() ? "one without a name" : fmt::format("\"{}\"", oneLine(name)), reason));
    };
    std::size_t used = 0;
    for (const Light& light : model.lights)
        if (!entersWater(light, level))
            add("lights", light.name, "it does not get into the water");
        else if (++used > mostLights)
            add("lights", light.name, "eight are used at the most");
    if (!model.cameras.empty() && !scene.contains("camera"))
        add("cameras", "", "it does not see the model from above the floor");
    if (model.cameras.size() > 1) add("cameras", "", "the first one is used");
    return notices;
}

} // namespace limpid::io
