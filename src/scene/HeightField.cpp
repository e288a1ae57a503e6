#include "scene/HeightField.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace limpid {

namespace {

constexpr int rim = 2; ///< coefficients on each side that stay 0

/// Share of the height that is left at texel `i` of `count`.
float window(int i, int count, double fade) {
    if (fade <= 0) return 1;
    const double inside = std::min(i + 0.5, count - i - 0.5);
    const double s = std::min(inside / fade, 1.0);
    return float(s * s * s * (s * (6 * s - 15) + 10));
}

std::vector<float> windows(int count, double fade) {
    std::vector<float> shares;
    for (int i = 0; i < count; ++i)
        shares.push_back(window(i, count, fade));
    return shares;
}

/// What elimination leaves above the diagonal of c[i-1] + 4 c[i] + c[i+1] = 6 h[i], inside of the rim.
std::vector<float> eliminated(int count) {
    std::vector<float> upper(std::size_t(count), 0.0f);
    for (int i = rim; i < count - rim; ++i)
        upper[std::size_t(i)] = float(1 / (4.0 - double(upper[std::size_t(i) - 1])));
    return upper;
}

/// Heights to coefficients along x: one spline a row.
void solveRows(glm::ivec2 size, std::vector<float>& data) {
    const std::vector<float> upper = eliminated(size.x);
    for (int z = 0; z < size.y; ++z) {
        float* row = data.data() + std::size_t(z) * std::size_t(size.x);
        for (int i = 0; i < rim; ++i)
            row[i] = row[size.x - 1 - i] = 0;
        for (int i = rim; i < size.x - rim; ++i)
            row[i] = (6 * row[i] - row[i - 1]) * upper[std::size_t(i)];
        for (int i = size.x - rim - 1; i >= rim; --i)
            row[i] -= upper[std::size_t(i)] * row[i + 1];
    }
}

/// The same along z, all columns at once: memory is walked in its own order.
void solveColumns(glm::ivec2 size, std::vector<float>& data) {
    const std::vector<float> upper = eliminated(size.y);
    const auto row = [&](int z) { return data.data() + std::size_t(z) * std::size_t(size.x); };
    for (int i = 0; i < rim; ++i) {
        std::fill_n(row(i), size.x, 0.0f);
        std::fill_n(row(size.y - 1 - i), size.x, 0.0f);
    }
    for (int z = rim; z < size.y - rim; ++z)
        for (int x = 0; x < size.x; ++x)
            row(z)[x] = (6 * row(z)[x] - row(z - 1)[x]) * upper[std::size_t(z)];
    for (int z = size.y - rim - 1; z >= rim; --z)
        for (int x = 0; x < size.x; ++x)
            row(z)[x] -= upper[std::size_t(z)] * row(z + 1)[x];
}

/// A spline is a mean of its coefficients, and its derivative one of their differences.
void findBounds(HeightField& field) {
    float highest = 0, alongX = 0, alongZ = 0;
    for (int z = 1; z < field.size.y; ++z) {
        const float* above = field.spline.data() + std::size_t(z - 1) * std::size_t(field.size.x);
        const float* row = above + field.size.x;
        for (int x = 1; x < field.size.x; ++x) {
            highest = std::max(highest, std::abs(row[x]));
            alongX = std::max(alongX, std::abs(row[x] - row[x - 1]));
            alongZ = std::max(alongZ, std::abs(row[x] - above[x]));
        }
    }
    field.highest = double(highest);
    field.steepest = {double(alongX), double(alongZ)};
}

} // namespace

HeightField makeHeightField(glm::ivec2 size, std::vector<float> heights, const glm::dvec2& fade) {
    assert(std::min(size.x, size.y) >= HeightField::minSide);
    assert(heights.size() == std::size_t(size.x) * std::size_t(size.y));
    const std::vector<float> inX = windows(size.x, fade.x), inZ = windows(size.y, fade.y);
    for (std::size_t z = 0; z < inZ.size(); ++z)
        for (std::size_t x = 0; x < inX.size(); ++x)
            heights[z * inX.size() + x] *= inX[x] * inZ[z];
    solveRows(size, heights);
    solveColumns(size, heights);
    HeightField field;
    field.size = size;
    field.spline = std::move(heights);
    findBounds(field);
    return field;
}

} // namespace limpid
