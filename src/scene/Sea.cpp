#include "scene/Sea.h"

namespace limpid {

bool raiseSea(Wave& wave, const Wind& wind) {
    auto spectrum = phillipsSpectrum(wind);
    if (!spectrum) return false;
    wave.type = WaveType::Phillips;
    wave.spectrum = std::move(spectrum);
    wave.direction = wind.velocity;
    wave.size = wind.tile;
    wave.wavelength = wind.shortest;
    wave.seed = wind.seed;
    return true;
}

Wind windOf(const Wave& wave) {
    return {.velocity = wave.direction,
            .tile = wave.size,
            .modes = wave.spectrum->modes,
            .shortest = wave.wavelength,
            .seed = wave.seed};
}

} // namespace limpid
