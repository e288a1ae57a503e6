#include "core/Statistics.h"

#include <algorithm>
#include <cmath>

namespace limpid {

Spread spreadOf(std::vector<double> values) {
    if (values.empty()) return {};
    std::sort(values.begin(), values.end());
    const std::size_t count = values.size();
    const auto rank = std::size_t(std::ceil(0.95 * double(count)));
    return {values.front(), 0.5 * (values[(count - 1) / 2] + values[count / 2]), values[rank - 1]};
}

} // namespace limpid
