#include "core/ImageErrors.h"

#include <cmath>

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

} // namespace limpid
