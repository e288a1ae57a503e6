#include "plan/Warnings.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/Tau.h"
#include "plan/ModelWarnings.h"
#include "plan/WaveTerms.h"
#include "scene/MethodFacts.h"

namespace limpid {

namespace {

/// Metres of the shortest wave in a term; of a height map, the cosine that is as high and as steep.
double shortest(const Wave& wave) {
    if (wave.type == WaveType::HeightMap)
        return tau * highestWave(wave) / std::max(steepestSlope(wave), 1e-12);
    if (wave.type == WaveType::Phillips) return wave.spectrum->shortest;
    return wave.type == WaveType::Noise ? wave.wavelength / std::exp2(wave.octaves - 1) : wave.wavelength;
}

/// Metres of the waves that a term mostly is of.
double longest(const Wave& wave) {
    if (wave.type == WaveType::Phillips) return tau / wave.spectrum->rmsSlope;
    return wave.type == WaveType::HeightMap ? shortest(wave) : wave.wavelength;
}

void warnOfTexels(std::vector<std::string>& warnings, const Scene& scene) {
    double length = 0;
    for (const Wave& wave : scene.water.waves)
        if (wave.amplitude != 0) length = std::max(length, longest(wave));
    if (length == 0) return;
    for (const Receiver& receiver : scene.receivers) {
        const glm::dvec3 size = worldBounds(receiver).size();
        if (const double texel = std::max(size.x, size.z) / scene.caustics.mapSize; texel > length)
            warnings.push_back(
                fmt::format("receiver.{}: expected texels smaller than the waves ({:.3g} m), found {:.3g} m; "
                            "no caustics show "
                            "in them; a greater caustics.map_size or a receiver in pieces would show some",
                            receiver.name, length, texel));
    }
}

/// Integers of few bits have stairs for waves, which bend light by themselves.
void warnOfSteps(std::vector<std::string>& warnings, const Scene& scene) {
    constexpr double coarse = 2.0 / 1000; // 8 bits have 2 / 255
    for (std::size_t i = 0; i < scene.water.waves.size(); ++i) {
        const Wave& wave = scene.water.waves[i];
        if (wave.type != WaveType::HeightMap || wave.amplitude == 0 || wave.heights->step() < coarse)
            continue;
        warnings.push_back(
            fmt::format("water.wave.{}: expected heights of 16 bits or floating point, found steps of "
                        "{:.3g} m, which bend light by themselves",
                        i, wave.heights->step() * std::abs(wave.amplitude)));
    }
}

void warnOfWaves(std::vector<std::string>& warnings, const Scene& scene, const WaterPatch& patch) {
    const glm::dvec2 quad = patch.size / glm::dvec2(patch.grid);
    const double coarsest = std::max(quad.x, quad.y);
    for (std::size_t i = 0; i < scene.water.waves.size(); ++i)
        if (const double length = shortest(scene.water.waves[i]); length < 2 * coarsest)
            warnings.push_back(
                fmt::format("water.wave.{}: expected waves of at least two quads ({:.3g} m), found {:.3g} m; "
                            "a finer water.grid would show them",
                            i, 2 * coarsest, length));
    // From straight above, a ray bends by about a quarter of the slope; past a slope of 1 it may come out
    // again.
    if (const double slope = steepestSlope(scene.water); slope > 1)
        warnings.push_back(
            fmt::format("water.wave: expected slopes below 1, found up to {:.3g}; beams may cross the "
                        "surface again, which is not followed",
                        slope));
}

} // namespace

std::vector<std::string> sceneWarnings(const Scene& scene, const WaterPatch& patch) {
    std::vector<std::string> warnings;
    for (const Receiver& receiver : scene.receivers)
        for (const std::string& notice : receiver.mesh->notices)
            if (std::find(warnings.begin(), warnings.end(), notice) == warnings.end())
                warnings.push_back(notice);
    for (const Receiver& receiver : scene.receivers)
        for (std::string& warning : modelWarnings(receiver, scene.water))
            warnings.push_back(std::move(warning));
    warnOfWaves(warnings, scene, patch);
    warnOfSteps(warnings, scene);
    warnOfTexels(warnings, scene);
    for (const Light& light : scene.lights) {
        if (!entersWater(light, scene.water))
            warnings.push_back(fmt::format(
                "light.{}: does not enter the water from above, so it makes no caustics", light.name));
        if (light.angularDiameter > 0 && !sumsBeams(scene.caustics))
            warnings.push_back(
                fmt::format("light.{}.angular_diameter: not used by {}, which takes the light as a point far "
                            "away; exact-beam and level maps in one pass do",
                            light.name, methodName(scene.caustics.method)));
    }
    for (const Receiver& receiver : scene.receivers)
        if (worldBounds(receiver).min.y >= scene.water.level)
            warnings.push_back(
                fmt::format("receiver.{}: lies above the water, so no caustics fall on it", receiver.name));
    return warnings;
}

} // namespace limpid
