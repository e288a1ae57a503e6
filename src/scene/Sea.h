#pragma once
#include "scene/Scene.h"
#include "scene/Spectrum.h"

/// Phillips waves, which keep their wind in fields that other waves use: velocity in `direction`, tile in
/// `size`, the shortest wave in `wavelength` (0: as tile and modes have it), `modes` and `seed`.
namespace limpid {

/// Keeps the wind; waves there are none yet.
void setWind(Wave& wave, const Wind& wind);

/// Makes `wave` a phillips wave of its amplitude. Returns false, and leaves it as it is, if the wind raises
/// none of the tile's modes.
bool raiseSea(Wave& wave, const Wind& wind);

/// What a phillips wave was made from.
Wind windOf(const Wave& wave);

} // namespace limpid
