#include "limpid/SceneChecks.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "core/Error.h"

namespace limpid {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Of finite numbers; an open end is not in it.
struct Range {
    double min = -infinity, max = infinity;
    bool openMin = false, openMax = false;

    bool has(double v) const {
        return std::isfinite(v) && (openMin ? v > min : v >= min) && (openMax ? v < max : v <= max);
    }
    std::string text() const {
        if (min == -infinity) return "a finite number";
        if (max == infinity) return fmt::format("a finite number {} {}", openMin ? ">" : ">=", min);
        return fmt::format("a number in {}{}, {}{}", openMin ? '(' : '[', min, max, openMax ? ')' : ']');
    }
};
constexpr Range finite{}, nonNegative{.min = 0}, positive{.min = 0, .openMin = true};

void require(const std::string& place, double value, const Range& range) {
    if (!range.has(value)) failCheck(place, range.text(), fmt::format("{}", value));
}

template <int N, typename T>
void require(const std::string& place, const glm::vec<N, T>& value, const Range& range) {
    for (int i = 0; i < N; ++i)
        require(place, double(value[i]), range);
}

template <int N>
void requireDirection(const std::string& place, const glm::vec<N, double>& value) {
    require(place, value, finite);
    if (!(glm::length(value) > 0)) failCheck(place, "a direction of a length > 0", "0");
}

void requireCamera(const Camera& camera) {
    if (camera.position) require("camera.position", *camera.position, finite);
    if (camera.target) require("camera.target", *camera.target, finite);
    if (camera.position && camera.target && *camera.position == *camera.target)
        failCheck("camera.target", "a point other than the position", "the same");
    requireDirection("camera.up", camera.up);
    require("camera.verticalFov", camera.verticalFov,
            {.min = 0, .max = 180, .openMin = true, .openMax = true});
    require("camera.exposure", camera.exposure, {.min = -64, .max = 64});
}

void requireTexture(const std::string& place, const Wave& wave) {
    if (wave.type == WaveType::Phillips) {
        if (!wave.spectrum) failCheck(place + ".spectrum", "the one that raiseSea makes", "none");
        return;
    }
    if (!wave.heights) failCheck(place + ".heights", "a source of heights", "none");
    require(place + ".center", wave.center, finite);
    require(place + ".size", wave.size, positive);
    require(place + ".fps", wave.fps, positive);
}

void requireWave(const std::string& place, const Wave& wave) {
    require(place + ".amplitude", wave.amplitude, finite);
    if (isTexture(wave.type)) {
        requireTexture(place, wave);
        return;
    }
    require(place + ".wavelength", wave.wavelength, positive);
    require(place + ".speed", wave.speed, finite);
    require(place + ".phase", wave.phase, finite);
    if (wave.type == WaveType::Cosine) requireDirection(place + ".direction", wave.direction);
    if (wave.type == WaveType::Circular) require(place + ".center", wave.center, finite);
    if (wave.type == WaveType::Noise) require(place + ".octaves", wave.octaves, {.min = 1, .max = 12});
}

void requireWater(const Water& water) {
    require("water.level", water.level, finite);
    if (water.center) require("water.center", *water.center, finite);
    if (water.size) require("water.size", *water.size, positive);
    require("water.grid", water.grid, {.min = 1, .max = 8192});
    require("water.ior", water.ior, {.min = 1, .max = 4});
    require("water.absorption", water.absorption, nonNegative);
    require("water.scattering", water.scattering, nonNegative);
    require("water.anisotropy", water.anisotropy, {.min = -1, .max = 1, .openMin = true, .openMax = true});
    for (std::size_t i = 0; i < water.waves.size(); ++i)
        requireWave(fmt::format("water.waves[{}]", i), water.waves[i]);
    const auto textures = std::count_if(water.waves.begin(), water.waves.end(),
                                        [](const Wave& wave) { return isTexture(wave.type); });
    if (textures > maxHeightMaps)
        failCheck("water.waves", fmt::format("at most {} height maps and spectra", maxHeightMaps),
                  fmt::format("{}", textures));
}

void requireLight(const std::string& place, const Light& light) {
    if (light.type == LightType::Directional) {
        requireDirection(place + ".direction", light.direction);
        require(place + ".irradiance", light.irradiance, nonNegative);
        require(place + ".angularDiameter", light.angularDiameter, {.min = 0, .max = 10});
        return;
    }
    require(place + ".position", light.position, finite);
    require(place + ".intensity", light.intensity, nonNegative);
    if (!light.isSpot()) return;
    requireDirection(place + ".direction", light.direction);
    require(place + ".outerCone", light.outerCone, {.min = 0, .max = 90, .openMin = true});
    require(place + ".innerCone", light.innerCone, {.min = 0, .max = light.outerCone, .openMax = true});
}

void requireReceiver(const std::string& place, const Receiver& receiver) {
    if (!receiver.mesh) failCheck(place + ".mesh", "a mesh", "none");
    requireMesh(*receiver.mesh, place + ".mesh");
    require(place + ".translation", receiver.translation, finite);
    require(place + ".scale", receiver.scale, finite);
    for (int i = 0; i < 3; ++i)
        if (receiver.scale[i] == 0) failCheck(place + ".scale", "numbers other than 0", "0");
    if (const double length = glm::length(receiver.rotation); !(std::abs(length - 1) < 1e-3))
        failCheck(place + ".rotation", "a quaternion of length 1", fmt::format("{}", length));
}

void requireCaustics(const CausticsSettings& caustics) {
    require("caustics.mapSize", caustics.mapSize, {.min = 1, .max = 16384});
    require("caustics.planes", caustics.planes, {.min = 1, .max = 4096});
    require("caustics.depthLevels", caustics.depthLevels, {.min = 1, .max = 4096});
    require("caustics.threshold", caustics.threshold, {.min = 0, .max = 1, .openMin = true});
    require("caustics.texelsPerPixel", caustics.texelsPerPixel, {.min = 0, .max = 64});
    require("caustics.refresh", caustics.refresh, {.min = 0, .max = 1000});
    require("caustics.photonGrid", caustics.photonGrid, {.min = 1, .max = 8192});
    require("caustics.photonSubdivision", caustics.photonSubdivision, {.min = 1, .max = 16});
    require("caustics.splatSize", caustics.splatSize, {.min = 1, .max = 256});
    if (caustics.splatSize.x > caustics.splatSize.y)
        failCheck("caustics.splatSize", "the smaller size first",
                  fmt::format("{}, {}", caustics.splatSize.x, caustics.splatSize.y));
    require("caustics.filterTaps", caustics.filterTaps, {.min = 0, .max = 32});
    require("caustics.filterRadius", caustics.filterRadius, {.min = 0, .max = 64});
}

void requireGodrays(const GodraySettings& godrays) {
    require("godrays.grid", godrays.grid, {.min = 1, .max = 4096});
    require("godrays.subdivision", godrays.subdivision, {.min = 1, .max = 16});
    require("godrays.scale", godrays.scale, {.min = 0, .max = 1, .openMin = true});
    require("godrays.lineWidth", godrays.lineWidth, {.min = 0.5, .max = 256});
    require("godrays.filterTaps", godrays.filterTaps, {.min = 0, .max = 32});
    require("godrays.filterRadius", godrays.filterRadius, {.min = 0, .max = 64});
    require("godrays.planes", godrays.planes, {.min = 1, .max = 1024});
    require("godrays.steps", godrays.steps, {.min = 1, .max = 4096});
    require("godrays.subVolumes", godrays.subVolumes, {.min = 0, .max = 256});
}

} // namespace

void failCheck(const std::string& place, const std::string& expected, const std::string& got) {
    throw InputError(fmt::format("{}: expected {}, got {}", place, expected, got));
}

void requireScene(const Scene& scene) {
    requireCamera(scene.camera);
    requireWater(scene.water);
    for (std::size_t i = 0; i < scene.lights.size(); ++i)
        requireLight(fmt::format("lights[{}]", i), scene.lights[i]);
    for (std::size_t i = 0; i < scene.receivers.size(); ++i)
        requireReceiver(fmt::format("receivers[{}]", i), scene.receivers[i]);
    require("skyRadiance", scene.skyRadiance, nonNegative);
    require("ambientRadiance", scene.ambientRadiance, nonNegative);
    requireCaustics(scene.caustics);
    requireGodrays(scene.godrays);
}

} // namespace limpid
