#pragma once
#include <cstddef>
#include <string_view>
#include <vector>

#include "scene/Scene.h"

namespace limpid {

/// What `water.preset` may be. Made for pools a few metres wide and a metre or two deep.
inline constexpr std::string_view waterPresets[] = {"calm pool", "breeze", "rain drops", "circular + noise",
                                                    "cosine + strong noise"};

/// The waves of waterPresets[preset]; drops fall around `center` (x, z in m).
std::vector<Wave> presetWaves(std::size_t preset, const glm::dvec2& center);

} // namespace limpid
