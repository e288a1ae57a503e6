#include "scene/Spectrum.h"

#include <algorithm>
#include <cmath>

#include "core/Tau.h"

namespace limpid {

namespace {

constexpr double gravity = 9.81;    // m/s²
constexpr double tension = 7.28e-5; // m³/s²: 0.0728 N/m at 20 °C over 1000 kg/m³

/// Steele, Lea and Flood 2014 (SplitMix).
std::uint64_t mixed(std::uint64_t x) {
    x += 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

/// Two independent normal numbers of variance 1 for a mode (Box and Muller 1958).
std::complex<double> normalPair(std::uint32_t seed, glm::ivec2 mode) {
    const auto number = std::uint64_t(std::uint32_t(mode.x)) << 32 | std::uint32_t(mode.y);
    const std::uint64_t bits = mixed(mixed(seed) ^ number);
    const double u = (double(bits >> 11) + 0.5) * 0x1p-53, v = double(mixed(bits) >> 11) * 0x1p-53;
    return std::polar(std::sqrt(-2 * std::log(u)), tau * v);
}

/// Tessendorf eq. 40 and 41 without its constant; waves against the wind have none.
double energy(const glm::dvec2& k, const Wind& wind, double shortest) {
    const double speed = glm::length(wind.velocity), longest = speed * speed / gravity;
    const double k2 = glm::dot(k, k), along = glm::dot(k, wind.velocity) / (std::sqrt(k2) * speed);
    if (!(along > 0)) return 0;
    const double cut = shortest / tau;
    return std::exp(-1 / (k2 * longest * longest) - k2 * cut * cut) / (k2 * k2) * along * along;
}

} // namespace

glm::dvec2 Spectrum::wavenumber(int column, int row) const {
    return tau * (glm::dvec2(column, row) - 0.5 * modes) / tile;
}

double Spectrum::frequency(double wavenumber) {
    return std::sqrt((gravity + tension * wavenumber * wavenumber) * wavenumber);
}

std::complex<double> Spectrum::at(int column, int row, double time) const {
    // Mode -modes/2 has no partner, and is left out.
    if (column == 0 || row == 0) return 0;
    const auto side = std::size_t(modes);
    const auto here = std::size_t(row) * side + std::size_t(column);
    const auto there = (side - std::size_t(row)) * side + side - std::size_t(column);
    const double turn = std::fmod(frequency(glm::length(wavenumber(column, row))) * time, tau);
    return amplitudes[here] * std::polar(1.0, -turn) + std::conj(amplitudes[there]) * std::polar(1.0, turn);
}

std::shared_ptr<const Spectrum> phillipsSpectrum(const Wind& wind) {
    Spectrum spectrum;
    spectrum.tile = wind.tile;
    spectrum.modes = wind.modes;
    spectrum.shortest =
        wind.shortest > 0 ? wind.shortest : 4 * std::max(wind.tile.x, wind.tile.y) / wind.modes;
    spectrum.amplitudes.resize(std::size_t(wind.modes) * std::size_t(wind.modes));
    double square = 0, slopeSquare = 0, crests = 0, slopes = 0;
    for (int row = 1; row < wind.modes; ++row)
        for (int column = 1; column < wind.modes; ++column) {
            const glm::ivec2 mode = glm::ivec2(column, row) - wind.modes / 2;
            if (mode == glm::ivec2(0)) continue;
            const glm::dvec2 k = spectrum.wavenumber(column, row);
            const std::complex<double> h =
                std::sqrt(energy(k, wind, spectrum.shortest)) * normalPair(wind.seed, mode);
            spectrum.amplitudes[std::size_t(row) * std::size_t(wind.modes) + std::size_t(column)] = h;
            // The mode and its mirror image -k together are one wave of amplitude 2 |h0|.
            square += 2 * std::norm(h);
            slopeSquare += 2 * std::norm(h) * glm::dot(k, k);
            crests += 2 * std::abs(h);
            slopes += 2 * std::abs(h) * glm::length(k);
        }
    if (!(square > 1e-200)) return nullptr;
    const double scale = 1 / std::sqrt(square);
    for (std::complex<double>& h : spectrum.amplitudes)
        h *= scale;
    spectrum.rmsSlope = scale * std::sqrt(slopeSquare);
    spectrum.highest = std::min(scale * crests, 6.0);
    spectrum.steepest = std::min(scale * slopes, 6 * spectrum.rmsSlope);
    return std::make_shared<const Spectrum>(std::move(spectrum));
}

} // namespace limpid
