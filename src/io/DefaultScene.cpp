#include "io/DefaultScene.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string>

#include <fmt/format.h>

#include "io/Files.h"
#include "io/SceneParser.h"
#include "scene/Scene.h"

namespace limpid::io {

namespace {

// The look of a model alone. Lengths are fractions of its largest extent s, so that it does not depend on
// size.
constexpr double floorSize = 6.5;
constexpr int mapSize = 1024;     ///< the floor is several times as wide as the model
constexpr double floorGap = 1e-4; ///< keeps a flat base and the floor from being one surface
constexpr double waterAbove = 0.6;
constexpr glm::dvec3 absorption{0.3, 0.07, 0.035};  ///< over s
constexpr glm::dvec3 scattering{0.02, 0.03, 0.035}; ///< over s
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
constexpr CosineWave cosineWaves[] = {{0.55, 0.011, {1, 0.3}, 0}, {0.34, 0.006, {-0.4, 1}, 60}};
constexpr double noiseWavelength = 0.6;
constexpr double noiseAmplitude = 0.012;
constexpr int noiseOctaves = 2;

toml::array array(const glm::dvec3& v) {
    return toml::array{v.x, v.y, v.z};
}
toml::array array(const glm::dvec2& v) {
    return toml::array{v.x, v.y};
}

/// Of a gravity wave on deep water, m/s.
double waveSpeed(double wavelength) {
    return std::sqrt(9.81 * wavelength / (2 * std::numbers::pi));
}

toml::array waves(double s) {
    toml::array result;
    for (const CosineWave& wave : cosineWaves)
        result.push_back(toml::table{{"type", "cosine"},
                                     {"wavelength", wave.wavelength * s},
                                     {"amplitude", wave.amplitude * s},
                                     {"direction", array(wave.direction)},
                                     {"phase", wave.phase},
                                     {"speed", waveSpeed(wave.wavelength * s)}});
    result.push_back(toml::table{{"type", "noise"},
                                 {"wavelength", noiseWavelength * s},
                                 {"amplitude", noiseAmplitude * s},
                                 {"octaves", noiseOctaves},
                                 {"speed", waveSpeed(noiseWavelength * s)}});
    return result;
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
        toml::table lamp{{"name", name},
                         {"type", "point"},
                         {"position", array(light.position)},
                         {"intensity", array(light.intensity)}};
        if (!light.isSpot()) return lamp;
        lamp.insert_or_assign("type", "spot");
        lamp.insert("direction", array(light.direction));
        lamp.insert("inner_cone", light.innerCone);
        lamp.insert("outer_cone", light.outerCone);
        return lamp;
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

toml::table cameraTable(const Camera& camera) {
    return toml::table{{"position", array(*camera.position)},
                       {"target", array(*camera.target)},
                       {"up", array(camera.up)},
                       {"vertical_fov", camera.verticalFov}};
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
    const glm::dvec3 center = bounds.center();
    const double level = bounds.max.y + waterAbove * s;
    toml::table scene{
        {"water", toml::table{{"level", level},
                              {"absorption", array(absorption / s)},
                              {"scattering", array(scattering / s)},
                              {"wave", waves(s)}}},
        {"light", lights(model, level)},
        {"receiver",
         toml::array{
             toml::table{{"name", receiverName(file)}, {"gltf", std::filesystem::absolute(file).string()}},
             toml::table{
                 {"name", "floor"},
                 {"plane", toml::table{{"size", array(glm::dvec2(floorSize * s))}}},
                 {"translation", array(glm::dvec3(center.x, bounds.min.y - floorGap * s, center.z))}}}},
        {"caustics", toml::table{{"map_size", mapSize}}},
        {"ambient", toml::table{{"radiance", array(ambientRadiance)}}}};
    if (!model.cameras.empty() && seesModel(model.cameras.front(), bounds))
        scene.insert("camera", cameraTable(model.cameras.front()));
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
