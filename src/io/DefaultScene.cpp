#include "io/DefaultScene.h"

#include <algorithm>
#include <cmath>
#include <numbers>

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
constexpr glm::dvec3 sunDirection{0.35, -1, 0.2};
constexpr glm::dvec3 sunIrradiance{6, 5.8, 5.4};
constexpr glm::dvec3 ambientRadiance{0.16, 0.22, 0.26};

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

/// The file's stem with everything that names may not hold replaced; "model" if that leaves nothing, or the
/// floor's name.
std::string receiverName(const std::filesystem::path& model) {
    std::string name = model.stem().string().substr(0, 100);
    for (char& c : name)
        if (!isName(std::string(1, c)) && c != '.') c = '_';
    if (name.find_first_not_of("_.") == std::string::npos || name == "floor" || !isName(name)) return "model";
    return name;
}

} // namespace

toml::table defaultScene(const std::filesystem::path& model, const Mesh& mesh) {
    Bounds bounds;
    for (const glm::dvec3& p : mesh.positions)
        bounds.add(p);
    const glm::dvec3 size = bounds.size();
    const double extent = std::max({size.x, size.y, size.z});
    // A model of no size still needs a floor and waves of some; below a micrometre nothing is to be seen.
    const double s = extent > 1e-6 ? extent : 1.0;
    const glm::dvec3 center = bounds.center();
    return toml::table{
        {"water", toml::table{{"level", bounds.max.y + waterAbove * s},
                              {"absorption", array(absorption / s)},
                              {"scattering", array(scattering / s)},
                              {"wave", waves(s)}}},
        {"light", toml::array{toml::table{{"name", "sun"},
                                          {"direction", array(glm::normalize(sunDirection))},
                                          {"irradiance", array(sunIrradiance)}}}},
        {"receiver",
         toml::array{
             toml::table{{"name", receiverName(model)}, {"gltf", std::filesystem::absolute(model).string()}},
             toml::table{
                 {"name", "floor"},
                 {"plane", toml::table{{"size", array(glm::dvec2(floorSize * s))}}},
                 {"translation", array(glm::dvec3(center.x, bounds.min.y - floorGap * s, center.z))}}}},
        {"caustics", toml::table{{"map_size", mapSize}}},
        {"ambient", toml::table{{"radiance", array(ambientRadiance)}}}};
}

} // namespace limpid::io
