#pragma once
#include <cstddef>
#include <optional>
#include <string_view>

#include "scene/Scene.h"

namespace limpid {

/// What `water.type` may be. The first, which is the default, neither absorbs nor scatters.
inline constexpr std::string_view waterBodies[] = {"clearest", "pool", "clear ocean", "coastal"};

/// Absorption, scattering (1/m, RGB) and anisotropy of waterBodies[body].
void setWaterBody(std::size_t body, Water& water);
/// The body that has just these values, if one does.
std::optional<std::size_t> waterBodyOf(const Water& water);

} // namespace limpid
