#pragma once
#include <complex>
#include <cstdint>
#include <memory>
#include <vector>

#include <glm/glm.hpp>

namespace limpid {

/// What a sea raised by wind is made from.
struct Wind {
    glm::dvec2 velocity{3, 0}; ///< m/s along x and z, not 0
    glm::dvec2 tile{4};        ///< m; the waves repeat after it
    int modes = 64;            ///< a side, a power of two, [minModes, maxModes]
    double shortest = 0; ///< m; shorter waves die away; 0: four times the tile's longer side over `modes`
    std::uint32_t seed = 0;

    static constexpr int minModes = 4, maxModes = 512;
};

/// The waves of a tile (Tessendorf, "Simulating Ocean Water", eq. 19, 40 and 43). The height over place x and
/// time t is the real sum over all modes k of
///     h(k, t) e^(i k·x),   h(k, t) = h0(k) e^(-iω(k)t) + conj(h0(-k)) e^(iω(k)t),
/// in which h0(k) runs along +k. Waves against the wind are left out, so that |h(k, t)| rests, and with it
/// the mean square height: it is 1 m², to be scaled by the wave's amplitude. A mode's draw depends on the
/// seed and its own number only: with more modes the same long waves get shorter company.
struct Spectrum {
    glm::dvec2 tile{1};
    int modes = 0;
    /// h0, m: modes², row by row; column c and row r are mode (c - modes/2, r - modes/2).
    std::vector<std::complex<double>> amplitudes;
    double rmsSlope = 0; ///< of the gradient's length
    double highest = 0;  ///< bounds (see below) of height and slope
    double steepest = 0;
    double shortest = 0; ///< m

    /// 1/m, of the mode at column and row.
    glm::dvec2 wavenumber(int column, int row) const;
    /// ω(k), 1/s, for |k| in 1/m: deep water under gravity and surface tension.
    static double frequency(double wavenumber);
    /// h(k, t) of the mode at column and row.
    std::complex<double> at(int column, int row, double time) const;
};

/// The bounds are what all crests at one place would come to or, if that is less, six times the root mean
/// square: heights and slopes of many waves are spread normally, and one in 10⁸ gets that far.
/// Null if the wind raises none of the tile's modes.
std::shared_ptr<const Spectrum> phillipsSpectrum(const Wind& wind);

} // namespace limpid
