#include "plan/WaveTerms.h"

#include <algorithm>
#include <cmath>

#include "core/Tau.h"

namespace limpid {

namespace {

gpu::WaveTerm cosineTerm(const Wave& wave, const glm::dvec3& origin, double time) {
    const glm::dvec2 direction = glm::normalize(wave.direction);
    const double k = tau / wave.wavelength;
    const double there = glm::dot(direction, glm::dvec2(origin.x, origin.z)) - wave.speed * time;
    const double phase = k * std::fmod(there, wave.wavelength) + glm::radians(wave.phase);
    return {
        glm::vec4(wave.amplitude, k, std::fmod(phase, tau), 0), glm::vec4(direction, 0, 0), {0, 0, 0, 0}, {}};
}

gpu::WaveTerm circularTerm(const Wave& wave, const glm::dvec3& origin, double time) {
    const double k = tau / wave.wavelength;
    const double phase = glm::radians(wave.phase) - k * std::fmod(wave.speed * time, wave.wavelength);
    const glm::dvec2 center = wave.center - glm::dvec2(origin.x, origin.z);
    return {
        glm::vec4(wave.amplitude, k, std::fmod(phase, tau), 0), glm::vec4(center, 0, 0), {1, 0, 0, 0}, {}};
}

gpu::WaveTerm noiseTerm(const Wave& wave, const glm::dvec3& origin, double time) {
    const glm::dvec3 at = glm::dvec3(origin.x, origin.z, wave.speed * time) / wave.wavelength;
    // The lattice repeats after 2^19 cells, so that the cell of the twelfth octave, 2^11 times as many, fits
    // an int.
    const glm::dvec3 whole = glm::floor(at);
    const glm::dvec3 part = at - whole;
    const auto wrap = [](double cell) { return int(std::fmod(cell, 524288.0)); };
    return {glm::vec4(wave.amplitude, 1 / wave.wavelength, part.z, 0),
            glm::vec4(part.x, part.y, 0, 0),
            {2, wave.octaves, int(wave.seed), 0},
            {wrap(whole.x), wrap(whole.y), wrap(whole.z), 0}};
}

} // namespace

std::vector<gpu::WaveTerm> waveTerms(const Water& water, const glm::dvec3& origin, double time) {
    std::vector<gpu::WaveTerm> terms;
    for (const Wave& wave : water.waves) {
        switch (wave.type) {
        case WaveType::Cosine:
            terms.push_back(cosineTerm(wave, origin, time));
            break;
        case WaveType::Circular:
            terms.push_back(circularTerm(wave, origin, time));
            break;
        case WaveType::Noise:
            terms.push_back(noiseTerm(wave, origin, time));
            break;
        case WaveType::HeightMap:
        case WaveType::Phillips:
            break; // textures: water/HeightMaps.h, water/SpectralWaves.h
        }
    }
    return terms;
}

double steepestSlope(const Wave& wave) {
    if (wave.type == WaveType::HeightMap) {
        const HeightBounds& bounds = wave.heights->bounds();
        return std::abs(wave.amplitude) *
               glm::length(bounds.steepest * glm::dvec2(bounds.size) / glm::abs(wave.size));
    }
    if (wave.type == WaveType::Phillips) return std::abs(wave.amplitude) * wave.spectrum->steepest;
    // Steepest slope of one octave of unit lattice and amplitude, found by search over all gradient choices
    // of a cell; each octave has half the height and half the length, so all are equally steep.
    constexpr double noiseSlope = 2.2;
    return std::abs(wave.amplitude) / wave.wavelength *
           (wave.type == WaveType::Noise ? noiseSlope * wave.octaves : tau);
}

double highestWave(const Wave& wave) {
    if (wave.type == WaveType::HeightMap) return std::abs(wave.amplitude) * wave.heights->bounds().highest;
    if (wave.type == WaveType::Phillips) return std::abs(wave.amplitude) * wave.spectrum->highest;
    return std::abs(wave.amplitude) * (wave.type == WaveType::Noise ? 2.1 : 1.0);
}

bool moves(const Water& water) {
    return std::any_of(water.waves.begin(), water.waves.end(),
                       [](const Wave& wave) {
                           return wave.speed != 0 || wave.spectrum ||
                                  (wave.heights && wave.heights->frameCount() > 1);
                       }) ||
           isLive(water);
}

bool isLive(const Water& water) {
    return std::any_of(water.waves.begin(), water.waves.end(),
                       [](const Wave& wave) { return wave.heights && wave.heights->texture() != 0; });
}

double steepestSlope(const Water& water) {
    double slope = 0;
    for (const Wave& wave : water.waves)
        slope += steepestSlope(wave);
    return slope;
}

double highestWave(const Water& water) {
    double height = 0;
    for (const Wave& wave : water.waves)
        height += highestWave(wave);
    return height;
}

} // namespace limpid
