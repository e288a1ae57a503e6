#pragma once
#include <array>

namespace limpid::reference {

/// The four pieces of a uniform cubic B-spline and their derivatives at `f` in [0, 1].
struct SplinePieces {
    std::array<double, 4> value, slope;

    explicit SplinePieces(double f)
        : value{(1 - f) * (1 - f) * (1 - f) / 6, (3 * f * f * f - 6 * f * f + 4) / 6,
                (-3 * f * f * f + 3 * f * f + 3 * f + 1) / 6, f * f * f / 6},
          slope{-(1 - f) * (1 - f) / 2, (3 * f * f - 4 * f) / 2, (-3 * f * f + 2 * f + 1) / 2, f * f / 2} {}
};

} // namespace limpid::reference
