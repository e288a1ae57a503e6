#pragma once
#include <complex>

#include <glm/glm.hpp>

#include "scene/Spectrum.h"

namespace limpid::test {

/// Height and slopes of a spectrum at a place and time, summed mode by mode as the definition says.
inline glm::dvec3 slowWaves(const Spectrum& spectrum, const glm::dvec2& place, double time) {
    glm::dvec3 sum(0);
    for (int row = 0; row < spectrum.modes; ++row)
        for (int column = 0; column < spectrum.modes; ++column) {
            const glm::dvec2 k = spectrum.wavenumber(column, row);
            const std::complex<double> wave =
                spectrum.at(column, row, time) * std::polar(1.0, glm::dot(k, place));
            sum += glm::dvec3(wave.real(), -k.x * wave.imag(), -k.y * wave.imag());
        }
    return sum;
}

} // namespace limpid::test
