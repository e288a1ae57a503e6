#include "scene/Sea.h"

namespace limpid {

void setWind(Wave& wave, const Wind& wind) {
    wave.type = WaveType::Phillips;
    wave.direction = wind.velocity;
    wave.size = wind.tile;
    wave.modes = wind.modes;
    wave.wavelength = wind.shortest;
    wave.seed = wind.seed;
}

bool raiseSea(Wave& wave, const Wind& wind) {
    auto spectrum = phillipsSpectrum(wind);
    if (!spectrum) return false;
    wave.spectrum = std::move(spectrum);
    setWind(wave, wind);
    return true;
}

Wind windOf(const Wave& wave) {
    return {.velocity = wave.direction,
            .tile = wave.size,
            .modes = wave.modes,
            .shortest = wave.wavelength,
            .seed = wave.seed};
}

} // namespace limpid
