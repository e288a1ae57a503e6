#include "Polygon.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace limpid::models {

namespace {

double cross(const glm::dvec2& a, const glm::dvec2& b) {
    return a.x * b.y - a.y * b.x;
}

double doubleArea(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
    return cross(b - a, c - a);
}

bool inside(const glm::dvec2& p, const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
    return doubleArea(a, b, p) >= 0.0 && doubleArea(b, c, p) >= 0.0 && doubleArea(c, a, p) >= 0.0;
}

// How good an ear the corner is: its smallest height over the longest side; negative if it is none.
double earAt(const std::vector<glm::dvec2>& polygon, const std::vector<std::uint32_t>& left, std::size_t i) {
    const std::size_t n = left.size();
    const std::uint32_t ia = left[(i + n - 1) % n], ib = left[i], ic = left[(i + 1) % n];
    const glm::dvec2 a = polygon[ia], b = polygon[ib], c = polygon[ic];
    const double area = doubleArea(a, b, c);
    if (area <= 1e-14) return -1.0;
    for (std::uint32_t other : left)
        if (other != ia && other != ib && other != ic && inside(polygon[other], a, b, c)) return -1.0;
    const double longest = std::max({glm::distance(a, b), glm::distance(b, c), glm::distance(c, a)});
    return area / (longest * longest);
}

} // namespace

std::vector<std::uint32_t> triangulated(const std::vector<glm::dvec2>& polygon) {
    std::vector<std::uint32_t> left(polygon.size());
    for (std::size_t i = 0; i < left.size(); ++i)
        left[i] = static_cast<std::uint32_t>(i);
    std::vector<std::uint32_t> triangles;
    while (left.size() >= 3) {
        std::size_t best = 0;
        double quality = -2.0;
        for (std::size_t i = 0; i < left.size(); ++i)
            if (const double q = earAt(polygon, left, i); q > quality) {
                quality = q;
                best = i;
            }
        const std::size_t n = left.size();
        triangles.insert(triangles.end(), {left[(best + n - 1) % n], left[best], left[(best + 1) % n]});
        left.erase(left.begin() + static_cast<std::ptrdiff_t>(best));
    }
    return triangles;
}

std::vector<glm::dvec2> inset(const std::vector<glm::dvec2>& polygon, double distance) {
    const std::size_t n = polygon.size();
    std::vector<glm::dvec2> result;
    for (std::size_t i = 0; i < n; ++i) {
        const glm::dvec2 before = glm::normalize(polygon[i] - polygon[(i + n - 1) % n]);
        const glm::dvec2 after = glm::normalize(polygon[(i + 1) % n] - polygon[i]);
        const glm::dvec2 inward = glm::dvec2{-before.y, before.x} + glm::dvec2{-after.y, after.x};
        result.push_back(polygon[i] + inward * (2.0 * distance / glm::dot(inward, inward)));
    }
    return result;
}

std::vector<glm::dvec2> rounded(const std::vector<glm::dvec2>& polygon, double radius, int steps) {
    const std::size_t n = polygon.size();
    std::vector<glm::dvec2> result;
    for (std::size_t i = 0; i < n; ++i) {
        const glm::dvec2 corner = polygon[i];
        const glm::dvec2 before = polygon[(i + n - 1) % n] - corner, after = polygon[(i + 1) % n] - corner;
        const double reach = std::min({radius, 0.45 * glm::length(before), 0.45 * glm::length(after)});
        const glm::dvec2 from = corner + reach * glm::normalize(before),
                         to = corner + reach * glm::normalize(after);
        for (int step = 0; step <= steps; ++step) {
            const double t = double(step) / steps;
            result.push_back((1.0 - t) * (1.0 - t) * from + 2.0 * t * (1.0 - t) * corner + t * t * to);
        }
    }
    return result;
}

} // namespace limpid::models
