#pragma once
#include <vector>

namespace limpid {

/// What a series of times is summed up by. Zero without a value.
struct Spread {
    double min = 0;
    double median = 0; ///< the mean of the middle two of an even number
    double p95 = 0;    ///< the smallest value that 95 % of all are not above
};

Spread spreadOf(std::vector<double> values);

} // namespace limpid
