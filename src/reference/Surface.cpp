#include "reference/Surface.h"

#include <algorithm>
#include <cmath>

#include "core/Optics.h"
#include "core/Tau.h"
#include "reference/SplinePieces.h"

namespace limpid::reference {

namespace {

/// Perlin's fade curve and its derivative (2002).
double fade(double f) {
    return f * f * f * (10 + f * (6 * f - 15));
}
double fadeSlope(double f) {
    return 30 * f * f * (1 - f) * (1 - f);
}

/// One octave: value and its derivatives by the first two coordinates, `local` in cells from the corner of
/// `cell`.
glm::dvec3 gradientNoise(const glm::ivec3& cell, const glm::dvec3& local, int seed) {
    const glm::dvec3 whole = glm::floor(local), f = local - whole;
    const glm::ivec3 base = cell + glm::ivec3(whole);
    const glm::dvec3 weight(fade(f.x), fade(f.y), fade(f.z));
    glm::dvec3 sum(0);
    for (int dz = 0; dz < 2; ++dz)
        for (int dy = 0; dy < 2; ++dy)
            for (int dx = 0; dx < 2; ++dx) {
                const glm::ivec3 corner(dx, dy, dz);
                const glm::dvec3 gradient(shader::latticeGradient(base + corner, seed));
                const double value = glm::dot(gradient, f - glm::dvec3(corner));
                const double x = dx ? weight.x : 1 - weight.x, y = dy ? weight.y : 1 - weight.y,
                             z = dz ? weight.z : 1 - weight.z;
                sum.x += x * y * z * value;
                sum.y += z * y * (x * gradient.x + (dx ? 1 : -1) * fadeSlope(f.x) * value);
                sum.z += z * x * (y * gradient.y + (dy ? 1 : -1) * fadeSlope(f.y) * value);
            }
    return sum;
}

} // namespace

glm::dvec3 Surface::Point::up() const {
    return glm::normalize(glm::dvec3(-slope.x, 1, -slope.y));
}

Surface::Surface(const Water& water, const glm::dvec3& origin, double time) {
    for (const Wave& wave : water.waves)
        add(wave, origin, time);
}

void Surface::bound(double height, double slope, double wavelength) {
    _highest += height;
    _steepest += slope;
    _shortest = _shortest > 0 ? std::min(_shortest, wavelength) : wavelength;
}

void Surface::add(const Wave& wave, const glm::dvec3& origin, double time) {
    const double amplitude = std::abs(wave.amplitude);
    const glm::dvec2 here(origin.x, origin.z);
    const double k = tau / wave.wavelength;
    const double turned = glm::radians(wave.phase) - k * std::fmod(wave.speed * time, wave.wavelength);
    switch (wave.type) {
    case WaveType::Cosine: {
        const glm::dvec2 along = glm::normalize(wave.direction);
        const double phase = k * std::fmod(glm::dot(along, here), wave.wavelength) + turned;
        _sines.push_back({wave.amplitude, k, phase, along, false});
        return bound(amplitude, amplitude * k, wave.wavelength);
    }
    case WaveType::Circular:
        _sines.push_back({wave.amplitude, k, turned, wave.center - here, true});
        return bound(amplitude, amplitude * k, wave.wavelength);
    case WaveType::Noise: {
        const glm::dvec3 at = glm::dvec3(here, wave.speed * time) / wave.wavelength;
        const glm::dvec3 whole = glm::floor(at);
        // The lattice is defined to repeat after 2^19 cells (water/WaveTerms).
        const glm::ivec3 cell(std::fmod(whole.x, 524288.0), std::fmod(whole.y, 524288.0),
                              std::fmod(whole.z, 524288.0));
        _noises.push_back(
            {wave.amplitude, 1 / wave.wavelength, at - whole, cell, wave.octaves, int(wave.seed)});
        // A gradient is √2 long and a corner at most √3 away, but weights make less of it: values stay
        // within 1.1 and slopes within 2.5, and each octave has half of the height at the same slope.
        return bound(2.2 * amplitude, 2.5 * amplitude / wave.wavelength * wave.octaves,
                     wave.wavelength / std::exp2(wave.octaves - 1));
    }
    case WaveType::HeightMap:
        return addHeights(wave, origin, time);
    case WaveType::Phillips:
        _tiles.push_back({std::make_shared<const WaveTile>(*wave.spectrum, time), wave.amplitude,
                          glm::mod(here, wave.spectrum->tile)});
        return bound(amplitude * wave.spectrum->highest, amplitude * wave.spectrum->steepest,
                     wave.spectrum->shortest);
    }
}

void Surface::addHeights(const Wave& wave, const glm::dvec3& origin, double time) {
    const int count = wave.heights->frameCount();
    double at = std::fmod(time * wave.fps, double(count));
    if (at < 0) at += count;
    // A time that is a frame's but for rounding shows that frame alone.
    if (std::abs(at - std::round(at)) < 1e-6) at = std::round(at);
    const int first = int(at) % count;
    const double share = count > 1 ? at - std::floor(at) : 0;
    const glm::dvec2 corner = wave.center - 0.5 * wave.size - glm::dvec2(origin.x, origin.z);
    for (int i = 0; i < (share > 0 ? 2 : 1); ++i) {
        const auto field = wave.heights->frame((first + i) % count);
        const glm::dvec2 texels = glm::dvec2(field->size) / wave.size;
        const double amplitude = wave.amplitude * (i == 0 ? 1 - share : share);
        _heights.push_back({field, amplitude, corner, texels});
        bound(std::abs(amplitude) * field->highest,
              std::abs(amplitude) * glm::length(field->steepest * glm::abs(texels)),
              2 / std::max(std::abs(texels.x), std::abs(texels.y)));
    }
}

void Surface::addSine(const Sine& sine, const glm::dvec2& place, Point& sum) {
    glm::dvec2 along = sine.place;
    double distance;
    if (sine.circular) {
        const glm::dvec2 away = place - sine.place;
        distance = glm::length(away);
        along = distance > 1e-9 ? away / distance : glm::dvec2(0);
    } else {
        distance = glm::dot(along, place);
    }
    const double angle = sine.wavenumber * distance + sine.phase;
    sum.height += sine.amplitude * std::cos(angle);
    sum.slope -= sine.amplitude * sine.wavenumber * std::sin(angle) * along;
}

void Surface::addNoise(const Noise& noise, const glm::dvec2& place, Point& sum) {
    double scale = 1;
    glm::ivec3 cell = noise.cell;
    for (int octave = 0; octave < noise.octaves; ++octave) {
        const glm::dvec3 local =
            scale * (noise.offset + glm::dvec3(place.x * noise.cells, place.y * noise.cells, 0));
        const glm::dvec3 value = gradientNoise(cell, local, noise.seed + octave);
        sum.height += noise.amplitude / scale * value.x;
        sum.slope += noise.amplitude * noise.cells * glm::dvec2(value.y, value.z);
        scale *= 2;
        cell *= 2;
    }
}

void Surface::addField(const Heights& heights, const glm::dvec2& place, Point& sum) {
    const HeightField& field = *heights.field;
    const glm::dvec2 at = (place - heights.corner) * heights.texels - 0.5; // from the middle of texel 0
    if (at.x < -1 || at.y < -1 || at.x > field.size.x || at.y > field.size.y) return;
    const glm::dvec2 whole = glm::floor(at);
    const SplinePieces x(at.x - whole.x), z(at.y - whole.y);
    const glm::ivec2 first = glm::ivec2(whole) - 1;
    for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 4; ++i) {
            const int column = first.x + i, row = first.y + j;
            if (column < 0 || row < 0 || column >= field.size.x || row >= field.size.y) continue;
            const double c =
                heights.amplitude *
                double(field.spline[std::size_t(row) * std::size_t(field.size.x) + std::size_t(column)]);
            const std::size_t a = std::size_t(i), b = std::size_t(j);
            sum.height += c * x.value[a] * z.value[b];
            sum.slope.x += c * x.slope[a] * z.value[b] * heights.texels.x;
            sum.slope.y += c * x.value[a] * z.slope[b] * heights.texels.y;
        }
}

Surface::Point Surface::at(const glm::dvec2& place) const {
    Point sum;
    for (const Sine& sine : _sines)
        addSine(sine, place, sum);
    for (const Noise& noise : _noises)
        addNoise(noise, place, sum);
    for (const Heights& heights : _heights)
        addField(heights, place, sum);
    for (const Tile& tile : _tiles) {
        const glm::dvec3 waves = tile.amplitude * tile.waves->at(place + tile.corner);
        sum.height += waves.x;
        sum.slope += glm::dvec2(waves.y, waves.z);
    }
    return sum;
}

} // namespace limpid::reference
