#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include <glm/glm.hpp>

namespace limpid {

/// CIE 1976 L*, u*, v* of a linear Rec. 709 colour, white point D65 (CIE 15:2004). Negative and NaN
/// components count as 0.
glm::dvec3 luvFromLinear(const glm::dvec3& rgb);

/// Average intensity difference of two images, thesis eq. 2-9: the mean over object pixels of the distance in
/// CIE Luv. `a` and `b`: linear RGB, 3 floats a pixel; `mask`: one float a pixel, > 0 on the object, or empty
/// for all. 0 where no pixel is on the object.
double luvDifference(std::span<const float> a, std::span<const float> b, std::span<const float> mask = {});

/// One channel of a stored picture to linear light: the inverse of IEC 61966-2-1.
float linearFromSrgb(float stored);

/// Two images of one size, `b` the truth. Rows and sizes are the caller's business.
struct ImagePair {
    std::span<const float> a, b;   ///< RGB, 3 floats a pixel
    std::span<const float> mask{}; ///< one a pixel, > 0 where the two are compared; empty: everywhere
    std::span<const float> area{}; ///< one a pixel, m²: the flux ratio's weights; empty: all alike
    double peak = 0;               ///< of PSNR; 0: the largest value of `b`
    double white = 1;              ///< the value that Luv takes for white
};

/// What separates two images. Means are over pixels and channels. A pixel that is NaN or infinite in either
/// image is counted and left out of every figure. Without a pixel to compare every figure is NaN; figures
/// relative to a black truth are 0 if the other image is black as well, else infinite.
struct ImageErrors {
    std::size_t pixels = 0;                         ///< compared
    std::size_t notFiniteInA = 0, notFiniteInB = 0; ///< pixels
    double mean = 0;                                ///< of `b`
    double nmae = 0;                                ///< mean |a − b| / mean b
    double nrmse = 0;                               ///< √(mean (a − b)²) / mean b
    /// Mean of (a − b)² / (b² + 0.01 · mean²): errors in dark places weigh as in bright ones, down to a tenth
    /// of the mean.
    double relmse = 0;
    double psnr = 0;           ///< dB, 20 log10(peak / √(mean (a − b)²)); infinite for equal images
    double luv = 0;            ///< thesis eq. 2-9
    double largest = 0;        ///< largest |a − b| of any channel
    std::size_t largestAt = 0; ///< its pixel
    double fluxRatio = 1;      ///< Σ area · a / Σ area · b
};

ImageErrors imageErrors(const ImagePair& pair);

/// A picture of a − b, 8-bit RGB: white where they are equal, red where `a` is brighter, blue where it is
/// darker, full colour at `range`; grey outside of the mask, black where either is not finite.
std::vector<unsigned char> differencePicture(const ImagePair& pair, double range);

} // namespace limpid
