#pragma once
#include <optional>

#include "plan/FlatWater.h"

namespace limpid {

/// Seen from a point light, a quad that beams start from is no wider than this many radians.
inline constexpr double pointLightTurn = 1.0 / 8;

/// The patch for a point light so close to the water that quads of `patch` are wider than pointLightTurn
/// allows: their lines halved again and again towards the point light. That is few lines even for one that
/// almost touches the water: their number goes with the logarithm of its height. Nothing where `patch` will
/// do.
std::optional<WaterPatch> pointLightPatch(const Light& light, const Water& water, const WaterPatch& patch);

} // namespace limpid
