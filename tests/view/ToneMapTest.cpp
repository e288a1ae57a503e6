#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

#include "view/ToneMapped.h"

namespace limpid {
namespace {

std::uint8_t shown(float radiance, double exposure = 0) {
    return toneMapped({{1, 1}, {radiance, radiance, radiance}}, exposure)[1];
}

TEST(ToneMap, runsFromBlackToWhite) {
    EXPECT_EQ(shown(0), 0);
    EXPECT_EQ(shown(4), 255) << "the smallest luminance that is white";
    EXPECT_EQ(shown(1e30f), 255);
    EXPECT_EQ(shown(-1), 0);
    EXPECT_EQ(shown(std::numeric_limits<float>::quiet_NaN()), 0);
    for (float r = 0.01f; r < 4; r *= 1.1f)
        EXPECT_LE(shown(r), shown(1.1f * r));
}

TEST(ToneMap, exposureIsInStops) {
    EXPECT_EQ(shown(0.25f, 2), shown(1));
}

TEST(ToneMap, dithersToTheMean) {
    Picture picture{{64, 64}, std::vector<float>(3 * 64 * 64, 0.1f)};
    const auto rgb = toneMapped(picture, 0);
    const auto [low, high] = std::minmax_element(rgb.begin(), rgb.end());
    EXPECT_EQ(*high - *low, 1) << "two neighbouring steps, mixed";
}

TEST(ToneMap, keepsHue) {
    const auto rgb = toneMapped({{1, 1}, {0.8f, 0.4f, 0.2f}}, 0);
    EXPECT_GT(rgb[0], rgb[1]);
    EXPECT_GT(rgb[1], rgb[2]);
}

} // namespace
} // namespace limpid
