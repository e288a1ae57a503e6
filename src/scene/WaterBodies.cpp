#include "scene/WaterBodies.h"

#include <array>

namespace limpid {

namespace {

/// Where a display's primaries are, about: R, G and B, nm.
constexpr std::array<double, 3> wavelengths{650, 550, 450};

/// 1/m at those wavelengths.
struct Body {
    std::array<double, 3> absorption;
    double scattering; ///< at 514 nm
};

// Absorption: pure water after Pope and Fry (Applied Optics 36, 1997, table 3); natural waters by the
// attenuation of daylight that Jerlov tabulates (Marine Optics, 1976, table XXVII: ocean type I, coastal type
// 3), which is their absorption within some tenth, as backscatter and slanting ways nearly make up for each
// other. Scattering: Petzold's waters at 514 nm (Volume Scattering Functions for Selected Ocean Waters,
// 1972): Tongue of the Ocean, and off San Pedro; a pool is taken to be as clear as the first.
constexpr Body bodies[] = {{{0, 0, 0}, 0},
                           {{0.340, 0.0565, 0.00922}, 0.037},
                           {{0.36, 0.063, 0.019}, 0.037},
                           {{0.46, 0.19, 0.39}, 0.219}};

/// Mean cosine of Petzold's average particle (Mobley, Sundman and Boss, Applied Optics 41, 2002).
constexpr double petzoldAnisotropy = 0.924;

} // namespace

void setWaterBody(std::size_t body, Water& water) {
    for (int c = 0; c < 3; ++c) {
        const auto channel = std::size_t(c);
        water.absorption[c] = bodies[body].absorption[channel];
        // Particles scatter as the inverse of the wavelength (Gordon and Morel, 1983).
        water.scattering[c] = bodies[body].scattering * 514 / wavelengths[channel];
    }
    water.anisotropy = body > 0 ? petzoldAnisotropy : Water{}.anisotropy;
}

std::optional<std::size_t> waterBodyOf(const Water& water) {
    for (std::size_t body = 0; body < std::size(waterBodies); ++body) {
        Water own;
        setWaterBody(body, own);
        if (own.absorption == water.absorption && own.scattering == water.scattering &&
            own.anisotropy == water.anisotropy)
            return body;
    }
    return std::nullopt;
}

} // namespace limpid
