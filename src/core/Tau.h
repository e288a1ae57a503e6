#pragma once
#include <numbers>

namespace limpid {

inline constexpr double tau = 2 * std::numbers::pi; ///< radians of a full turn

} // namespace limpid
