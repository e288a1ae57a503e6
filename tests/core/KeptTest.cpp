#include "core/Kept.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace limpid {
namespace {

TEST(Kept, isMadeAgainOnlyIfWhatItIsFromHasChanged) {
    Making making;
    Kept<std::string> kept;
    int made = 0;
    const auto bring = [&](const char* from) { return kept.bring(making, from, [&] { ++made; }); };
    EXPECT_EQ(kept.stamp(), 0u);
    EXPECT_TRUE(bring("calm"));
    const Stamp first = kept.stamp();
    EXPECT_FALSE(bring("calm"));
    EXPECT_EQ(kept.stamp(), first);
    EXPECT_TRUE(bring("rough"));
    EXPECT_GT(kept.stamp(), first);
    EXPECT_TRUE(bring("calm")) << "what it was before does not count";
    EXPECT_EQ(made, 3);
}

TEST(Kept, isMadeOnceMoreAfterAllStartsAnew) {
    Making making;
    Kept<int> kept;
    kept.bring(making, 1, [] {});
    making.startAnew();
    EXPECT_TRUE(kept.bring(making, 1, [] {}));
    EXPECT_FALSE(kept.bring(making, 1, [] {})) << "once is enough";
}

TEST(Kept, isNotThereAfterMakingItFailed) {
    Making making;
    Kept<int> kept;
    kept.bring(making, 1, [] {});
    EXPECT_THROW(kept.bring(making, 2, [] { throw std::runtime_error("no memory"); }), std::runtime_error);
    EXPECT_EQ(kept.stamp(), 0u);
    EXPECT_TRUE(kept.bring(making, 1, [] {})) << "what it was before may be half overwritten";
}

TEST(Kept, stampsAreNeverGivenTwice) {
    Making making;
    Kept<int> one, other;
    one.bring(making, 1, [] {});
    other.bring(making, 1, [] {});
    EXPECT_NE(one.stamp(), other.stamp());
    const Stamp before = one.stamp();
    one.forget();
    one.bring(making, 1, [] {});
    EXPECT_NE(one.stamp(), before);
}

} // namespace
} // namespace limpid
