#include "apps/viewer/Ladder.h"

namespace limpid::viewer {

void Ladder::measured(std::size_t step, double ms, double target) {
    constexpr double reserve = 0.7;
    const auto expected = [&](std::size_t other) { return ms * _shares[other] / _shares[step]; };
    if (ms > target) {
        // What does not shrink with the work makes a step's share a hope; the next measurement corrects it.
        std::size_t coarser = step;
        while (coarser < last() && expected(coarser) > target)
            ++coarser;
        _step = coarser;
        return;
    }
    std::size_t finest = step;
    while (finest > 0 && expected(finest - 1) <= reserve * target)
        --finest;
    _step = finest;
}

} // namespace limpid::viewer
