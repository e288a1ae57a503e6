#pragma once
#include <string_view>

namespace limpid {

/// True for a name that authors give to water itself ("Water", "pool_water.001", "SM_SeaSurface", "Wasser"):
/// of a word for water and words without a meaning of their own. What is only near or for water
/// ("underwater_rock", "watermelon", "water tank", "sea floor") is none. ASCII case does not count.
bool namesWater(std::string_view name);

} // namespace limpid
