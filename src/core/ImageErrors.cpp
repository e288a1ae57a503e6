#include "core/ImageErrors.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace limpid {

glm::dvec3 luvFromLinear(const glm::dvec3& rgb) {
    const glm::dvec3 c(rgb.x > 0 ? rgb.x : 0, rgb.y > 0 ? rgb.y : 0, rgb.z > 0 ? rgb.z : 0);
    // IEC 61966-2-1: Rec. 709 primaries to XYZ, D65.
    const double x = 0.4124 * c.x + 0.3576 * c.y + 0.1805 * c.z;
    const double y = 0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z;
    const double z = 0.0193 * c.x + 0.1192 * c.y + 0.9505 * c.z;
    if (!(y > 0)) return glm::dvec3(0);
    constexpr double whiteSum = 0.9505 + 15 * 1.0 + 3 * 1.089;
    constexpr double whiteU = 4 * 0.9505 / whiteSum, whiteV = 9 * 1.0 / whiteSum;
    const double sum = x + 15 * y + 3 * z;
    constexpr double epsilon = 216.0 / 24389.0, kappa = 24389.0 / 27.0;
    const double lightness = y > epsilon ? 116 * std::cbrt(y) - 16 : kappa * y;
    return {lightness, 13 * lightness * (4 * x / sum - whiteU), 13 * lightness * (9 * y / sum - whiteV)};
}

double luvDifference(std::span<const float> a, std::span<const float> b, std::span<const float> mask) {
    double sum = 0;
    std::size_t pixels = 0;
    for (std::size_t i = 0; 3 * i + 2 < a.size(); ++i) {
        if (!mask.empty() && !(mask[i] > 0)) continue;
        const glm::dvec3 first(a[3 * i], a[3 * i + 1], a[3 * i + 2]),
            second(b[3 * i], b[3 * i + 1], b[3 * i + 2]);
        sum += glm::distance(luvFromLinear(first), luvFromLinear(second));
        ++pixels;
    }
    return pixels > 0 ? sum / double(pixels) : 0;
}

float linearFromSrgb(float stored) {
    return stored <= 0.04045f ? stored / 12.92f : std::pow((stored + 0.055f) / 1.055f, 2.4f);
}

namespace {

enum class Pixel { Left, NotFinite, Compared };

bool finite(std::span<const float> image, std::size_t pixel) {
    return std::isfinite(image[3 * pixel]) && std::isfinite(image[3 * pixel + 1]) &&
           std::isfinite(image[3 * pixel + 2]);
}

Pixel kind(const ImagePair& pair, std::size_t pixel) {
    if (!pair.mask.empty() && !(pair.mask[pixel] > 0)) return Pixel::Left;
    return finite(pair.a, pixel) && finite(pair.b, pixel) ? Pixel::Compared : Pixel::NotFinite;
}

template <typename Visit>
void eachCompared(const ImagePair& pair, Visit&& visit) {
    for (std::size_t i = 0; i < pair.b.size() / 3; ++i)
        if (kind(pair, i) == Pixel::Compared) visit(i);
}

/// `x` of a truth of size `size`.
double relative(double x, double size) {
    return x == 0 ? 0.0 : x / size;
}

struct Sums {
    double a = 0, b = 0, absolute = 0, square = 0, luv = 0, fluxA = 0, fluxB = 0, peak = 0;
};

void addPixel(Sums& sums, ImageErrors& errors, const ImagePair& pair, std::size_t pixel) {
    const double area = pair.area.empty() ? 1.0 : double(pair.area[pixel]);
    glm::dvec3 first, second;
    for (int c = 0; c < 3; ++c) {
        const double a = pair.a[3 * pixel + std::size_t(c)], b = pair.b[3 * pixel + std::size_t(c)];
        const double difference = std::abs(a - b);
        if (difference > errors.largest) errors.largest = difference, errors.largestAt = pixel;
        sums.a += a;
        sums.b += b;
        sums.absolute += difference;
        sums.square += difference * difference;
        sums.fluxA += area * a;
        sums.fluxB += area * b;
        sums.peak = std::max(sums.peak, b);
        first[c] = a / pair.white;
        second[c] = b / pair.white;
    }
    sums.luv += glm::distance(luvFromLinear(first), luvFromLinear(second));
    ++errors.pixels;
}

} // namespace

ImageErrors imageErrors(const ImagePair& pair) {
    assert(pair.a.size() == pair.b.size() && pair.a.size() % 3 == 0);
    assert(pair.mask.empty() || pair.mask.size() == pair.b.size() / 3);
    assert(pair.area.empty() || pair.area.size() == pair.b.size() / 3);
    ImageErrors errors;
    Sums sums;
    for (std::size_t i = 0; i < pair.b.size() / 3; ++i) {
        const Pixel what = kind(pair, i);
        if (what == Pixel::Compared) addPixel(sums, errors, pair, i);
        if (what != Pixel::NotFinite) continue;
        errors.notFiniteInA += finite(pair.a, i) ? 0 : 1;
        errors.notFiniteInB += finite(pair.b, i) ? 0 : 1;
    }
    if (errors.pixels == 0) {
        constexpr double none = std::numeric_limits<double>::quiet_NaN();
        errors.mean = errors.nmae = errors.nrmse = errors.relmse = errors.psnr = errors.luv = errors.largest =
            errors.fluxRatio = none;
        return errors;
    }
    const double values = 3 * double(errors.pixels), rootMeanSquare = std::sqrt(sums.square / values);
    errors.mean = sums.b / values;
    errors.nmae = relative(sums.absolute / values, errors.mean);
    errors.nrmse = relative(rootMeanSquare, errors.mean);
    const double floor = 0.01 * errors.mean * errors.mean;
    eachCompared(pair, [&](std::size_t i) {
        for (std::size_t c = 3 * i; c < 3 * i + 3; ++c) {
            const double a = pair.a[c], b = pair.b[c];
            errors.relmse += relative((a - b) * (a - b), b * b + floor) / values;
        }
    });
    errors.psnr = 20 * std::log10((pair.peak > 0 ? pair.peak : sums.peak) / rootMeanSquare);
    if (rootMeanSquare == 0) errors.psnr = std::numeric_limits<double>::infinity();
    errors.luv = sums.luv / double(errors.pixels);
    errors.fluxRatio = sums.fluxA == sums.fluxB ? 1.0 : sums.fluxA / sums.fluxB;
    return errors;
}

std::vector<unsigned char> differencePicture(const ImagePair& pair, double range) {
    std::vector<unsigned char> out(pair.b.size());
    for (std::size_t i = 0; i < pair.b.size() / 3; ++i) {
        glm::dvec3 color(0.5);
        const Pixel what = kind(pair, i);
        if (what == Pixel::NotFinite) color = glm::dvec3(0);
        if (what == Pixel::Compared) {
            double difference = 0;
            for (std::size_t c = 3 * i; c < 3 * i + 3; ++c)
                difference += (double(pair.a[c]) - double(pair.b[c])) / 3;
            const double share = difference == 0 ? 0.0 : std::clamp(difference / range, -1.0, 1.0);
            color = share > 0 ? glm::dvec3(1, 1 - share, 1 - share) : glm::dvec3(1 + share, 1 + share, 1);
        }
        for (int c = 0; c < 3; ++c)
            out[3 * i + std::size_t(c)] = static_cast<unsigned char>(std::lround(255 * color[c]));
    }
    return out;
}

} // namespace limpid
