#include "core/ImageErrors.h"

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

namespace limpid {
namespace {

TEST(Luv, hasKnownValues) {
    const glm::dvec3 white = luvFromLinear({1, 1, 1});
    EXPECT_NEAR(white.x, 100, 1e-9);
    EXPECT_NEAR(white.y, 0, 0.02);
    EXPECT_NEAR(white.z, 0, 0.02);
    // Published Luv of the Rec. 709 primaries (e.g. Lindbloom's calculator): red 53.24, 175.01, 37.76.
    const glm::dvec3 red = luvFromLinear({1, 0, 0});
    EXPECT_NEAR(red.x, 53.24, 0.01);
    EXPECT_NEAR(red.y, 175.01, 0.05);
    EXPECT_NEAR(red.z, 37.76, 0.05);
    EXPECT_EQ(luvFromLinear({0, -1, std::numeric_limits<double>::quiet_NaN()}), glm::dvec3(0));
}

TEST(LuvDifference, isAMeanOverTheObject) {
    const std::array<float, 6> a{1, 1, 1, 0, 0, 0}, b{0, 0, 0, 0, 0, 0};
    EXPECT_EQ(luvDifference(a, a), 0);
    EXPECT_NEAR(luvDifference(a, b), 50, 0.01);
    const std::array<float, 2> first{1, 0}, none{0, 0};
    EXPECT_NEAR(luvDifference(a, b, first), 100, 0.01);
    EXPECT_EQ(luvDifference(a, b, none), 0);
}

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

/// Grey pixels as RGB.
std::vector<float> grey(std::initializer_list<float> values) {
    std::vector<float> rgb;
    for (const float v : values)
        rgb.insert(rgb.end(), 3, v);
    return rgb;
}

// Every figure of four numbers by hand. Values are exact in binary, sums are of a few doubles: what is off is
// rounding in the last place.
TEST(ImageErrors, areWhatTheirFormulasSay) {
    const auto a = grey({1.5f, 2, 4, 0}), b = grey({1, 2, 2, 3});
    const ImageErrors errors = imageErrors({a, b});
    EXPECT_EQ(errors.pixels, 4u);
    EXPECT_DOUBLE_EQ(errors.mean, 2);
    EXPECT_DOUBLE_EQ(errors.nmae, (0.5 + 0 + 2 + 3) / 4 / 2);
    const double meanSquare = (0.25 + 0 + 4 + 9) / 4;
    EXPECT_DOUBLE_EQ(errors.nrmse, std::sqrt(meanSquare) / 2);
    EXPECT_DOUBLE_EQ(errors.relmse, (0.25 / 1.04 + 4 / 4.04 + 9 / 9.04) / 4);
    EXPECT_DOUBLE_EQ(errors.psnr, 20 * std::log10(3 / std::sqrt(meanSquare)));
    EXPECT_EQ(errors.largest, 3);
    EXPECT_EQ(errors.largestAt, 3u);
    EXPECT_DOUBLE_EQ(errors.fluxRatio, 7.5 / 8);
    EXPECT_DOUBLE_EQ(imageErrors({.a = a, .b = b, .peak = 1}).psnr, -10 * std::log10(meanSquare));
}

TEST(ImageErrors, ofEqualImagesAreNone) {
    const auto a = grey({0.25f, 7, 0});
    const ImageErrors errors = imageErrors({a, a});
    for (const double zero : {errors.nmae, errors.nrmse, errors.relmse, errors.luv, errors.largest})
        EXPECT_EQ(zero, 0);
    EXPECT_EQ(errors.psnr, infinity);
    EXPECT_EQ(errors.fluxRatio, 1);
}

TEST(ImageErrors, ofATwofoldScale) {
    const auto b = grey({1, 2, 3, 4, 5}), scaled = grey({2, 4, 6, 8, 10});
    const ImageErrors errors = imageErrors({scaled, b});
    EXPECT_DOUBLE_EQ(errors.nmae, 1);
    EXPECT_DOUBLE_EQ(errors.fluxRatio, 2);
    EXPECT_DOUBLE_EQ(errors.nrmse, std::sqrt(11.0) / 3);
    // Figures but the largest error have no unit: a thousandfold of both changes none.
    std::vector<float> bigB = b, bigA = scaled;
    for (std::size_t i = 0; i < b.size(); ++i)
        bigB[i] *= 1024, bigA[i] *= 1024;
    const ImageErrors big = imageErrors({.a = bigA, .b = bigB, .white = 1024});
    EXPECT_DOUBLE_EQ(big.nmae, errors.nmae);
    EXPECT_DOUBLE_EQ(big.nrmse, errors.nrmse);
    EXPECT_DOUBLE_EQ(big.relmse, errors.relmse);
    EXPECT_DOUBLE_EQ(big.psnr, errors.psnr);
    EXPECT_DOUBLE_EQ(big.luv, errors.luv);
    EXPECT_DOUBLE_EQ(big.largest, 1024 * errors.largest);
}

TEST(ImageErrors, areOfTheMaskOnly) {
    const auto a = grey({9, 2, 1}), b = grey({1, 1, 1});
    const std::array<float, 3> mask{0, 1, 1};
    const ImageErrors errors = imageErrors({a, b, mask});
    EXPECT_EQ(errors.pixels, 2u);
    EXPECT_DOUBLE_EQ(errors.nmae, 0.5);
    EXPECT_EQ(errors.largest, 1);
    EXPECT_EQ(errors.largestAt, 1u);
}

TEST(ImageErrors, weighFluxByArea) {
    const auto a = grey({2, 1}), b = grey({1, 1});
    const std::array<float, 2> area{1, 3};
    EXPECT_DOUBLE_EQ(imageErrors({.a = a, .b = b, .area = area}).fluxRatio, 5.0 / 4);
    EXPECT_DOUBLE_EQ(imageErrors({a, b}).fluxRatio, 1.5);
}

TEST(ImageErrors, countWhatIsNotFinite) {
    auto a = grey({1, 1, 1, 3}), b = grey({1, 1, 1, 2});
    a[1] = nan;
    a[3] = infinity;
    b[4] = nan;
    b[7] = -infinity;
    const ImageErrors errors = imageErrors({a, b});
    EXPECT_EQ(errors.pixels, 1u);
    EXPECT_EQ(errors.notFiniteInA, 2u);
    EXPECT_EQ(errors.notFiniteInB, 2u);
    EXPECT_DOUBLE_EQ(errors.nmae, 0.5) << "of the pixel that is left";
    EXPECT_EQ(errors.largestAt, 3u);
    const std::array<float, 4> mask{0, 0, 1, 1};
    EXPECT_EQ(imageErrors({a, b, mask}).notFiniteInA, 0u) << "nobody asks about it";
}

TEST(ImageErrors, ofNothingAreNoNumbers) {
    const auto a = grey({1});
    const std::array<float, 1> none{0};
    const ImageErrors errors = imageErrors({a, a, none});
    EXPECT_EQ(errors.pixels, 0u);
    for (const double figure : {errors.nmae, errors.nrmse, errors.relmse, errors.psnr, errors.luv,
                                errors.largest, errors.fluxRatio})
        EXPECT_TRUE(std::isnan(figure));
}

TEST(ImageErrors, againstBlackAreInfinite) {
    const auto lit = grey({1, 0}), black = grey({0, 0});
    const ImageErrors errors = imageErrors({lit, black});
    for (const double figure : {errors.nmae, errors.nrmse, errors.relmse, errors.fluxRatio})
        EXPECT_EQ(figure, infinity);
    EXPECT_EQ(errors.psnr, -infinity);
    EXPECT_EQ(imageErrors({black, black}).nmae, 0);
    EXPECT_EQ(imageErrors({black, black}).fluxRatio, 1);
}

TEST(Srgb, isDecodedByTheStandard) {
    EXPECT_EQ(linearFromSrgb(0), 0);
    EXPECT_NEAR(linearFromSrgb(1), 1, 1e-6);
    // IEC 61966-2-1: 0.5 is 0.21404 in linear light.
    EXPECT_NEAR(linearFromSrgb(0.5f), 0.21404f, 1e-5);
}

TEST(DifferencePicture, isRedAboveAndBlueBelow) {
    auto a = grey({2, 1, 0, 9, 1, 1.5f});
    const auto b = grey({1, 1, 1, 1, 1, 1});
    a[12] = nan;
    const std::array<float, 6> mask{1, 1, 1, 0, 1, 1};
    const auto picture = differencePicture({a, b, mask}, 1);
    const std::vector<unsigned char> expected{255, 0,   0,   255, 255, 255, 0,   0,   255,
                                              128, 128, 128, 0,   0,   0,   255, 128, 128};
    EXPECT_EQ(picture, expected);
}

} // namespace
} // namespace limpid
