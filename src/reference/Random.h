#pragma once
#include <cstdint>

#include <glm/glm.hpp>

namespace limpid::reference {

/// Numbers that depend on nothing but what they are asked for, so that it does not matter who asks first.
/// Steele, Lea and Flood 2014 (SplitMix).
inline std::uint64_t mixed(std::uint64_t x) {
    x += 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}
inline std::uint64_t mixed(std::uint64_t a, std::uint64_t b) {
    return mixed(mixed(a) ^ b);
}

/// In [0, 1).
inline double unit(std::uint64_t bits) {
    return double(bits >> 11) * 0x1p-53;
}
inline glm::dvec2 unitSquare(std::uint64_t bits) {
    return {unit(bits), unit(mixed(bits))};
}

/// Evenly spread places in the unit square: the R2 sequence (Roberts 2018).
inline glm::dvec2 spread(const glm::dvec2& start, int i) {
    return glm::fract(start + double(i) * glm::dvec2(0.7548776662466927, 0.5698402909980532));
}

} // namespace limpid::reference
