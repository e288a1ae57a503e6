#include "scene/WaterPresets.h"

#include <cmath>
#include <random>
#include <span>

#include "core/Tau.h"

namespace limpid {

namespace {

struct Cosine {
    double wavelength; ///< m
    double amplitude;  ///< m
    double heading;    ///< degrees from x towards z
    double phase;      ///< degrees
};
struct Noise {
    double wavelength; ///< m
    double amplitude;  ///< m
    int octaves;
    std::uint32_t seed;
};
struct Drops {
    int count;
    double wavelength; ///< m, of the middle one
    double spread;     ///< share by which the shortest and the longest differ from it
    double amplitude;  ///< m
    double area;       ///< m, side of the square that they fall in
    std::uint32_t seed;
};

// A long low swell that hardly focuses, and ripples that do, a little.
constexpr Cosine calmPool[] = {{2.4, 0.0035, 15, 0}, {1.5, 0.0020, -40, 130}, {0.9, 0.0010, 70, 250}};
constexpr Noise calmPoolNoise{0.55, 0.0110, 2, 1};

// About one direction, each with slopes of 2 to 3 %: together they focus at a depth of a metre or so.
constexpr Cosine breeze[] = {{0.95, 0.0045, 0, 0},
                             {0.63, 0.0030, 22, 75},
                             {0.47, 0.0022, -17, 160},
                             {0.34, 0.0016, 9, 305},
                             {0.23, 0.0009, -31, 220}};
constexpr Noise breezeNoise{0.60, 0.0040, 2, 2};

// Rings at all stages at once: none fades, so twelve of them look like rain and not like twelve drops.
constexpr Drops rainDrops{12, 0.12, 0.2, 0.0005, 4, 3};

// The two waters of Papadopoulos and Papaioannou 4.1: rings with a little noise, and one cosine along an axis
// with much. Their heights are not given; these focus at a metre or two.
constexpr double ringWavelength = 0.5, ringAmplitude = 0.006; // m
constexpr Noise weakNoise{0.40, 0.0040, 2, 4};
constexpr Cosine longCosine[] = {{0.80, 0.0080, 0, 0}};
constexpr Noise strongNoise{0.50, 0.0200, 2, 5};

/// Of a wave on deep water driven by gravity and surface tension, m/s (H. Lamb, Hydrodynamics, § 267).
double waveSpeed(double wavelength) {
    constexpr double gravity = 9.81;    // m/s²
    constexpr double tension = 7.28e-5; // m³/s²: 0.0728 N/m at 20 °C over 1000 kg/m³
    const double k = tau / wavelength;
    return std::sqrt(gravity / k + tension * k);
}

Wave waveOf(WaveType type, double wavelength, double amplitude) {
    Wave wave;
    wave.type = type;
    wave.wavelength = wavelength;
    wave.amplitude = amplitude;
    wave.speed = waveSpeed(wavelength);
    return wave;
}

std::vector<Wave> wavesOf(std::span<const Cosine> cosines, const Noise& noise) {
    std::vector<Wave> waves;
    for (const Cosine& cosine : cosines) {
        waves.push_back(waveOf(WaveType::Cosine, cosine.wavelength, cosine.amplitude));
        const double heading = glm::radians(cosine.heading);
        waves.back().direction = {std::cos(heading), std::sin(heading)};
        waves.back().phase = cosine.phase;
    }
    waves.push_back(waveOf(WaveType::Noise, noise.wavelength, noise.amplitude));
    waves.back().octaves = noise.octaves;
    waves.back().seed = noise.seed;
    return waves;
}

std::vector<Wave> wavesOf(const Drops& drops, const glm::dvec2& center) {
    std::mt19937 generator(drops.seed);
    // The library's own distributions differ from one implementation to the next.
    const auto random = [&] { return double(generator()) / 4294967296.0; };
    std::vector<Wave> waves;
    for (int i = 0; i < drops.count; ++i) {
        const double longer = drops.spread * (2.0 * i / (drops.count - 1) - 1);
        waves.push_back(waveOf(WaveType::Circular, drops.wavelength * (1 + longer), drops.amplitude));
        const double x = random() - 0.5, z = random() - 0.5;
        waves.back().center = center + drops.area * glm::dvec2(x, z);
        waves.back().phase = 360 * random();
    }
    return waves;
}

} // namespace

std::vector<Wave> presetWaves(std::size_t preset, const glm::dvec2& center) {
    if (preset == 0) return wavesOf(calmPool, calmPoolNoise);
    if (preset == 1) return wavesOf(breeze, breezeNoise);
    if (preset == 2) return wavesOf(rainDrops, center);
    if (preset == 4) return wavesOf(longCosine, strongNoise);
    std::vector<Wave> waves = wavesOf({}, weakNoise);
    waves.push_back(waveOf(WaveType::Circular, ringWavelength, ringAmplitude));
    waves.back().center = center;
    return waves;
}

} // namespace limpid
