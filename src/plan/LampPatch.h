#pragma once
#include <optional>

#include "plan/FlatWater.h"

namespace limpid {

/// Seen from a lamp, a quad that beams start from is no wider than this many radians.
inline constexpr double lampTurn = 1.0 / 8;

/// The patch for a lamp so close to the water that quads of `patch` are wider than lampTurn allows: their
/// lines halved again and again towards the lamp. That is few lines even for one that almost touches the
/// water: their number goes with the logarithm of its height. Nothing where `patch` will do.
std::optional<WaterPatch> lampPatch(const Light& light, const Water& water, const WaterPatch& patch);

} // namespace limpid
