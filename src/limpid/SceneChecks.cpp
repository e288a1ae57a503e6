#include "limpid/SceneChecks.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "core/Error.h"
#include "scene/Keys.h"

// Ranges are those of the table of keys. What stands here is what no row can say: places as C++ names them,
// what depends on two members, and what a host may give that a file cannot.
namespace limpid {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Files keep numbers below 10¹²; a host's are to be finite.
Range ofHosts(Range range) {
    if (range.min == anyNumber.min) range.min = -infinity;
    if (range.max == anyNumber.max) range.max = infinity;
    return range;
}

std::string textOf(const Range& range) {
    if (range.min == -infinity) return "a finite number";
    if (range.max == infinity)
        return fmt::format("a finite number {} {}", range.openMin ? ">" : ">=", range.min);
    return fmt::format("a number in {}{}, {}{}", range.openMin ? '(' : '[', range.min, range.max,
                       range.openMax ? ')' : ']');
}

void require(const std::string& place, double value, const Range& ofTable) {
    const Range range = ofHosts(ofTable);
    if (!std::isfinite(value) || !range.contains(value))
        failCheck(place, textOf(range), fmt::format("{}", value));
}

template <int N, typename T>
void require(const std::string& place, const glm::vec<N, T>& value, const Range& range) {
    for (int i = 0; i < N; ++i)
        require(place, double(value[i]), range);
    if (range.direction && !(glm::length(glm::vec<N, double>(value)) > 0))
        failCheck(place, "a direction of a length > 0", "0");
}

template <typename T>
void require(const std::string& place, const std::optional<T>& value, const Range& range) {
    if (value) require(place, *value, range);
}

/// An object of a scene, its place in errors, and the table's rows of its members.
template <typename S>
struct Checked {
    std::string place;
    std::span<const Key<S>> keys;
    const S& object;

    template <typename T>
    void require(const char* name, T S::*member) const {
        limpid::require(at(name), object.*member, rangeOf(keys, member));
    }
    std::string at(const char* name) const { return place + "." + name; }
};

void requireCamera(const Camera& camera) {
    const Checked<Camera> checked{"camera", cameraKeys, camera};
    checked.require("position", &Camera::position);
    checked.require("target", &Camera::target);
    if (camera.position && camera.target && *camera.position == *camera.target)
        failCheck("camera.target", "a point other than the position", "the same");
    checked.require("up", &Camera::up);
    checked.require("verticalFov", &Camera::verticalFov);
    checked.require("exposure", &Camera::exposure);
}

void requireTexture(const Checked<Wave>& checked) {
    const Wave& wave = checked.object;
    if (wave.type == WaveType::Phillips) {
        if (!wave.spectrum) failCheck(checked.at("spectrum"), "the one that raiseSea makes", "none");
        return;
    }
    if (!wave.heights) failCheck(checked.at("heights"), "a source of heights", "none");
    checked.require("center", &Wave::center);
    checked.require("size", &Wave::size);
    checked.require("fps", &Wave::fps);
}

void requireWave(const std::string& place, const Wave& wave) {
    const Checked<Wave> checked{place, waveKeys, wave};
    checked.require("amplitude", &Wave::amplitude);
    if (isTexture(wave.type)) {
        requireTexture(checked);
        return;
    }
    checked.require("wavelength", &Wave::wavelength);
    checked.require("speed", &Wave::speed);
    checked.require("phase", &Wave::phase);
    if (wave.type == WaveType::Cosine) checked.require("direction", &Wave::direction);
    if (wave.type == WaveType::Circular) checked.require("center", &Wave::center);
    if (wave.type == WaveType::Noise) checked.require("octaves", &Wave::octaves);
}

void requireWater(const Water& water) {
    const Checked<Water> checked{"water", waterKeys, water};
    checked.require("level", &Water::level);
    checked.require("center", &Water::center);
    checked.require("size", &Water::size);
    checked.require("grid", &Water::grid);
    checked.require("ior", &Water::ior);
    checked.require("absorption", &Water::absorption);
    checked.require("scattering", &Water::scattering);
    checked.require("anisotropy", &Water::anisotropy);
    for (std::size_t i = 0; i < water.waves.size(); ++i)
        requireWave(fmt::format("water.waves[{}]", i), water.waves[i]);
    const auto textures = std::count_if(water.waves.begin(), water.waves.end(),
                                        [](const Wave& wave) { return isTexture(wave.type); });
    if (textures > maxHeightMaps)
        failCheck("water.waves", fmt::format("at most {} height maps and spectra", maxHeightMaps),
                  fmt::format("{}", textures));
}

void requireLight(const std::string& place, const Light& light) {
    const Checked<Light> checked{place, lightKeys, light};
    if (light.type == LightType::Directional) {
        checked.require("direction", &Light::direction);
        checked.require("irradiance", &Light::irradiance);
        checked.require("angularDiameter", &Light::angularDiameter);
        return;
    }
    checked.require("position", &Light::position);
    checked.require("intensity", &Light::intensity);
    if (!light.isSpot()) return;
    checked.require("direction", &Light::direction);
    checked.require("outerCone", &Light::outerCone);
    Range below = rangeOf(lightKeys, &Light::innerCone);
    below.max = light.outerCone, below.openMax = true;
    require(checked.at("innerCone"), light.innerCone, below);
}

void requireReceiver(const std::string& place, const Receiver& receiver) {
    const Checked<Receiver> checked{place, receiverKeys, receiver};
    if (!receiver.mesh) failCheck(checked.at("mesh"), "a mesh", "none");
    requireMesh(*receiver.mesh, checked.at("mesh"));
    checked.require("translation", &Receiver::translation);
    checked.require("scale", &Receiver::scale);
    for (int i = 0; i < 3; ++i)
        if (receiver.scale[i] == 0) failCheck(checked.at("scale"), "numbers other than 0", "0");
    // A file's is normalized as it is read.
    if (const double length = glm::length(receiver.rotation); !(std::abs(length - 1) < 1e-3))
        failCheck(checked.at("rotation"), "a quaternion of length 1", fmt::format("{}", length));
}

void requireCaustics(const CausticsSettings& caustics) {
    using C = CausticsSettings;
    const Checked<C> checked{"caustics", causticsKeys, caustics};
    checked.require("mapSize", &C::mapSize);
    checked.require("planes", &C::planes);
    checked.require("depthLevels", &C::depthLevels);
    checked.require("threshold", &C::threshold);
    checked.require("texelsPerPixel", &C::texelsPerPixel);
    checked.require("refresh", &C::refresh);
    checked.require("photonGrid", &C::photonGrid);
    checked.require("photonSubdivision", &C::photonSubdivision);
    checked.require("splatSize", &C::splatSize);
    if (caustics.splatSize.x > caustics.splatSize.y)
        failCheck("caustics.splatSize", "the smaller size first",
                  fmt::format("{}, {}", caustics.splatSize.x, caustics.splatSize.y));
    checked.require("filterTaps", &C::filterTaps);
    checked.require("filterRadius", &C::filterRadius);
}

void requireGodrays(const GodraySettings& godrays) {
    using G = GodraySettings;
    const Checked<G> checked{"godrays", godrayKeys, godrays};
    checked.require("grid", &G::grid);
    checked.require("subdivision", &G::subdivision);
    checked.require("scale", &G::scale);
    checked.require("lineWidth", &G::lineWidth);
    checked.require("filterTaps", &G::filterTaps);
    checked.require("filterRadius", &G::filterRadius);
    checked.require("planes", &G::planes);
    checked.require("steps", &G::steps);
    checked.require("subVolumes", &G::subVolumes);
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
    require("skyRadiance", scene.skyRadiance, rangeOf(skyKeys, &Scene::skyRadiance));
    require("ambientRadiance", scene.ambientRadiance, rangeOf(ambientKeys, &Scene::ambientRadiance));
    requireCaustics(scene.caustics);
    requireGodrays(scene.godrays);
}

} // namespace limpid
