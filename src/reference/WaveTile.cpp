#include "reference/WaveTile.h"

#include <algorithm>
#include <complex>

#include "core/Tau.h"
#include "reference/SplinePieces.h"

namespace limpid::reference {

namespace {

using Complex = std::complex<double>;

/// Σ_n line[n] e^(2πi n m / N) for all m, in place; N a power of two.
void transform(std::vector<Complex>& line) {
    const std::size_t count = line.size();
    if (count == 1) return;
    std::vector<Complex> even(count / 2), odd(count / 2);
    for (std::size_t i = 0; i < count / 2; ++i) {
        even[i] = line[2 * i];
        odd[i] = line[2 * i + 1];
    }
    transform(even);
    transform(odd);
    for (std::size_t i = 0; i < count / 2; ++i) {
        const Complex turned = odd[i] * std::polar(1.0, tau * double(i) / double(count));
        line[i] = even[i] + turned;
        line[i + count / 2] = even[i] - turned;
    }
}

/// What a cubic B-spline with coefficients e^(iφn) leaves of them at whole n.
double kept(double phase) {
    return (2 + std::cos(phase)) / 3;
}

} // namespace

WaveTile::WaveTile(const Spectrum& spectrum, double time) : _side(std::clamp(8 * spectrum.modes, 8, 4096)) {
    _texels = double(_side) / spectrum.tile;
    const auto side = std::size_t(_side), modes = std::size_t(spectrum.modes);
    const auto wave = [&](std::size_t mode) { return int(mode) - spectrum.modes / 2; };
    const auto place = [&](std::size_t mode) { return std::size_t(wave(mode) + _side) % side; };
    std::vector<std::vector<Complex>> rows(modes);
    for (std::size_t row = 0; row < modes; ++row) {
        rows[row].resize(side);
        for (std::size_t column = 0; column < modes; ++column)
            rows[row][place(column)] = spectrum.at(int(column), int(row), time) /
                                       (kept(tau * wave(column) / _side) * kept(tau * wave(row) / _side));
        transform(rows[row]);
    }
    _spline.resize(side * side);
    std::vector<Complex> line;
    for (std::size_t x = 0; x < side; ++x) {
        line.assign(side, 0);
        for (std::size_t row = 0; row < modes; ++row)
            line[place(row)] = rows[row][x];
        transform(line);
        for (std::size_t z = 0; z < side; ++z)
            _spline[z * side + x] = line[z].real();
    }
}

glm::dvec3 WaveTile::at(const glm::dvec2& place) const {
    const glm::dvec2 at = place * _texels, whole = glm::floor(at);
    const SplinePieces x(at.x - whole.x), z(at.y - whole.y);
    const auto first = glm::i64vec2(whole) - std::int64_t(1);
    glm::dvec3 sum(0);
    for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 4; ++i) {
            const auto column = std::size_t(first.x + i) & std::size_t(_side - 1);
            const auto row = std::size_t(first.y + j) & std::size_t(_side - 1);
            const double c = _spline[row * std::size_t(_side) + column];
            const auto a = std::size_t(i), b = std::size_t(j);
            sum += c * glm::dvec3(x.value[a] * z.value[b], x.slope[a] * z.value[b] * _texels.x,
                                  x.value[a] * z.slope[b] * _texels.y);
        }
    return sum;
}

} // namespace limpid::reference
