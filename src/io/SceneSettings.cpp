#include "io/SceneSettings.h"

#include <fmt/format.h>

#include "scene/Sea.h"
#include "scene/WaterBodies.h"

namespace limpid::io {

namespace {

/// The shortest text that is read as the same number.
std::string text(double value) {
    return fmt::format("{}", value);
}
std::string text(int value) {
    return fmt::format("{}", value);
}
std::string text(std::uint32_t value) {
    return fmt::format("{}", value);
}
std::string text(std::string_view value) {
    return fmt::format("\"{}\"", value);
}
template <int N, typename T>
std::string text(const glm::vec<N, T>& v) {
    std::string list;
    for (int i = 0; i < N; ++i)
        list += fmt::format("{}{}", i > 0 ? ", " : "", v[i]);
    return fmt::format("[{}]", list);
}

/// Gathers the keys of one table.
struct Table {
    std::vector<Setting>& settings;
    std::string section;
    int entry = -1;

    template <typename T>
    void add(const char* key, const T& value) {
        settings.push_back({section, entry, key, text(value)});
    }
    template <typename T>
    void add(const char* key, const std::optional<T>& value) {
        if (value) add(key, *value);
    }
};

void addCamera(Table table, const Camera& camera) {
    table.add("position", camera.position);
    table.add("target", camera.target);
    table.add("up", camera.up);
    table.add("vertical_fov", camera.verticalFov);
    table.add("exposure", camera.exposure);
}

void addWater(Table table, const Water& water) {
    table.add("level", water.level);
    table.add("center", water.center);
    table.add("size", water.size);
    table.add("grid", water.grid);
    table.add("ior", water.ior);
    if (const auto body = waterBodyOf(water)) {
        table.add("type", waterBodies[*body]);
        return;
    }
    table.add("absorption", water.absorption);
    table.add("scattering", water.scattering);
    table.add("anisotropy", water.anisotropy);
}

void addWind(Table table, const Wind& wind) {
    table.add("wind", wind.velocity);
    table.add("size", wind.tile);
    table.add("modes", wind.modes);
    if (wind.shortest > 0) table.add("shortest", wind.shortest);
    table.add("seed", wind.seed);
}

void addWave(Table table, const Wave& wave) {
    if (wave.type != WaveType::HeightMap) table.add("type", waveTypeNames[std::size_t(wave.type)]);
    table.add("amplitude", wave.amplitude);
    if (wave.type == WaveType::HeightMap) return;
    if (wave.type == WaveType::Phillips) {
        addWind(table, windOf(wave));
        return;
    }
    table.add("wavelength", wave.wavelength);
    table.add("speed", wave.speed);
    if (wave.type == WaveType::Cosine) table.add("direction", wave.direction);
    if (wave.type == WaveType::Circular) table.add("center", wave.center);
    if (wave.type != WaveType::Noise) {
        table.add("phase", wave.phase);
        return;
    }
    table.add("octaves", wave.octaves);
    table.add("seed", wave.seed);
}

void addLight(Table table, const Light& light) {
    if (light.type == LightType::Directional) {
        table.add("direction", light.direction);
        table.add("irradiance", light.irradiance);
        table.add("angular_diameter", light.angularDiameter);
        return;
    }
    table.add("position", light.position);
    table.add("intensity", light.intensity);
    if (!light.isSpot()) return;
    table.add("direction", light.direction);
    table.add("inner_cone", light.innerCone);
    table.add("outer_cone", light.outerCone);
}

void addReceiver(Table table, const Receiver& receiver) {
    table.add("translation", receiver.translation);
    const glm::dquat& q = receiver.rotation;
    table.add("rotation", glm::dvec4(q.x, q.y, q.z, q.w));
    table.add("scale", receiver.scale);
}

void addCaustics(Table table, const CausticsSettings& caustics) {
    constexpr std::string_view slicings[] = {"automatic", "levels"};
    table.add("method", methodName(caustics.method));
    table.add("map_size", caustics.mapSize);
    table.add("texels_per_pixel", caustics.texelsPerPixel);
    table.add("refresh", caustics.refresh);
    table.add("planes", caustics.planes);
    table.add("fill", fillName(caustics.fill));
    table.add("slicing", slicings[std::size_t(caustics.slicing)]);
    table.add("depth_levels", caustics.depthLevels);
    table.add("threshold", caustics.threshold);
    table.add("photon_grid", caustics.photonGrid);
    table.add("photon_grid_over", photonGridOverNames[std::size_t(caustics.photonGridOver)]);
    table.add("photon_subdivision", caustics.photonSubdivision);
    table.add("splat_size", caustics.splatSize);
    table.add("filter_taps", caustics.filterTaps);
    table.add("filter_radius", caustics.filterRadius);
}

void addGodrays(Table table, const GodraySettings& godrays) {
    constexpr std::string_view phases[] = {"henyey-greenstein", "schlick"};
    table.add("method", godrayMethodName(godrays.method));
    table.add("phase", phases[std::size_t(godrays.phase)]);
    table.add("grid", godrays.grid);
    table.add("subdivision", godrays.subdivision);
    table.add("planes", godrays.planes);
    table.add("steps", godrays.steps);
    table.add("sub_volumes", godrays.subVolumes);
    table.add("scale", godrays.scale);
    table.add("line_width", godrays.lineWidth);
    table.add("filter_taps", godrays.filterTaps);
    table.add("filter_radius", godrays.filterRadius);
}

} // namespace

std::vector<Setting> settingsOf(const Wave& wave, int entry) {
    std::vector<Setting> settings;
    addWave({settings, "water.wave", entry}, wave);
    return settings;
}

std::vector<Setting> settingsOf(const Scene& scene) {
    std::vector<Setting> all;
    addCamera({all, "camera"}, scene.camera);
    addWater({all, "water"}, scene.water);
    for (std::size_t i = 0; i < scene.water.waves.size(); ++i)
        addWave({all, "water.wave", int(i)}, scene.water.waves[i]);
    for (std::size_t i = 0; i < scene.lights.size(); ++i)
        addLight({all, "light", int(i)}, scene.lights[i]);
    for (std::size_t i = 0; i < scene.receivers.size(); ++i)
        addReceiver({all, "receiver", int(i)}, scene.receivers[i]);
    Table{all, "sky"}.add("radiance", scene.skyRadiance);
    Table{all, "ambient"}.add("radiance", scene.ambientRadiance);
    addCaustics({all, "caustics"}, scene.caustics);
    addGodrays({all, "godrays"}, scene.godrays);
    return all;
}

} // namespace limpid::io
