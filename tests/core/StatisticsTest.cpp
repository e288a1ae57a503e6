#include "core/Statistics.h"

#include <numeric>

#include <gtest/gtest.h>

namespace limpid {
namespace {

TEST(Spread, isThatOfTheSortedValues) {
    const Spread odd = spreadOf({5, 1, 3});
    EXPECT_EQ(odd.min, 1);
    EXPECT_EQ(odd.median, 3);
    EXPECT_EQ(odd.p95, 5);
    EXPECT_EQ(spreadOf({4, 1, 2, 9}).median, 3);
    EXPECT_EQ(spreadOf({7}).median, 7);
    EXPECT_EQ(spreadOf({7}).p95, 7);
    EXPECT_EQ(spreadOf({}).median, 0);
}

TEST(Spread, leavesOutTheWorstTwentieth) {
    std::vector<double> values(100);
    std::iota(values.rbegin(), values.rend(), 1.0);
    EXPECT_EQ(spreadOf(values).p95, 95);
    values.resize(20); // 81 to 100
    EXPECT_EQ(spreadOf(values).p95, 99);
}

} // namespace
} // namespace limpid
