#include "reference/TexelMap.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>

#include "reference/FootprintArea.h"
#include "reference/Random.h"

namespace limpid::reference {

namespace {

/// A face along the axis has no depth at a place; this is what its slope counts as, m by m.
constexpr double steepest = 20;

/// Square root of the mean of squares of `count` normal numbers about their mean, over their deviation, is
/// low by this factor in the mean.
double deviationBias(int count) {
    return std::sqrt(2.0 / (count - 1)) * std::exp(std::lgamma(0.5 * count) - std::lgamma(0.5 * (count - 1)));
}

} // namespace

glm::dvec2 depthGradient(const glm::dvec3& normal, const OrientedBox& box) {
    const double along = glm::dot(normal, box.t), least = 1 / steepest;
    const double divisor = std::abs(along) > least ? along : std::copysign(least, along);
    return -glm::dvec2(glm::dot(normal, box.u), glm::dot(normal, box.w)) / divisor;
}

bool TexelFace::goesOn(const glm::dvec2& at, double found, const MapSurface& surface, double texel) const {
    const double expected = depth + glm::dot(gradient, at - middle) * texel;
    const double crease = glm::length(gradient - surface.gradient);
    // A footprint on a gentle face may hold a strip of a steep one, but not the other way round.
    const bool strip = surface.spans && glm::length(surface.gradient) < glm::length(gradient);
    if (crease > mostCrease && !strip) return false;
    return std::abs(found - expected) <= texel * (0.5 + crease) + surface.slack;
}

TexelMap::TexelMap(const MapRequest& request, const SceneGeometry& geometry, const glm::dvec3& origin,
                   double level, Fixed fixed)
    : _request(request), _geometry(geometry), _box(request.frame.box), _level(level), _fixed(fixed) {
    _box.corner -= origin;
    const std::size_t count = std::size_t(size().x) * std::size_t(size().y);
    _texels.resize(count);
    _sums.resize(3 * count);
    _before.resize(count);
    _squares.resize(count);
}

MapPlace TexelMap::place(const glm::dvec3& point) const {
    const glm::dvec3 q = _box.local(point);
    return {q.x / texel(), q.y / texel(), q.z};
}

glm::dvec2 TexelMap::gradient(const glm::dvec3& normal) const {
    return depthGradient(normal, _box);
}

TexelMap::Texel TexelMap::cast(const glm::dvec2& at) const {
    const double before = 0.01 * _box.extent.z;
    const glm::dvec3 from = _box.point({at * texel(), -before});
    const Hit hit =
        _geometry.firstShown(_request.receiver, from, _box.t, _level, _request.faces, _request.facing);
    Texel texel;
    if (!hit) return texel;
    const double along = glm::dot(hit.normal, _box.t);
    texel.depth = float(hit.distance - before);
    // A face that the axis lies in has no area seen from here; the bake's normals end at this angle as well.
    texel.facing = float(std::max(std::abs(along), 4e-5));
    texel.gradient = glm::vec2(gradient(hit.normal));
    texel.normal = glm::vec3(along > 0 ? -hit.normal : hit.normal);
    texel.share = 1;
    return texel;
}

void TexelMap::see(int row) {
    for (int x = 0; x < size().x; ++x)
        _texels[index({x, row})] = cast({x + 0.5, row + 0.5});
}

/// Whether a surface at `depth` is the one that the texel shows.
bool TexelMap::takes(const Texel& texel, const glm::dvec2& middle, const glm::dvec2& at, double depth,
                     const MapSurface& surface) const {
    const TexelFace face{middle, double(texel.depth), glm::dvec2(texel.gradient)};
    return texel.facing != 0 && face.goesOn(at, depth, surface, this->texel());
}

/// Whether the texel may be covered in part only: it or a neighbour shows something else within a texel.
bool TexelMap::isRim(glm::ivec2 at) const {
    const Texel& own = _texels[index(at)];
    const glm::dvec2 middle = glm::dvec2(at) + 0.5;
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x) {
            const glm::ivec2 beside = at + glm::ivec2(x, y);
            if (beside.x < 0 || beside.y < 0 || beside.x >= size().x || beside.y >= size().y) return true;
            const Texel& other = _texels[index(beside)];
            if (other.facing == 0 || !takes(own, middle, glm::dvec2(beside) + 0.5, double(other.depth),
                                            {glm::dvec2(other.gradient)}))
                return true;
        }
    for (int i = 0; i < 4; ++i) {
        const glm::dvec2 within = middle + glm::dvec2(i % 2 ? 0.25 : -0.25, i / 2 ? 0.25 : -0.25);
        const Texel sample = cast(within);
        if (sample.facing == 0 ||
            !takes(own, middle, within, double(sample.depth), {glm::dvec2(sample.gradient)}))
            return true;
    }
    return false;
}

double TexelMap::coveredShare(glm::ivec2 at) const {
    constexpr int samples = 256;
    const Texel& own = _texels[index(at)];
    int covered = 0;
    for (int i = 0; i < samples; ++i) {
        const glm::dvec2 within = glm::dvec2(at) + spread({0.5, 0.5}, i);
        const Texel sample = cast(within);
        if (sample.facing > 0 &&
            takes(own, glm::dvec2(at) + 0.5, within, double(sample.depth), {glm::dvec2(sample.gradient)}))
            ++covered;
    }
    return std::max(covered, 1) / double(samples);
}

void TexelMap::findRims(int row) {
    for (int x = 0; x < size().x; ++x) {
        Texel& texel = _texels[index({x, row})];
        if (texel.facing > 0 && isRim({x, row})) texel.share = float(coveredShare({x, row}));
    }
}

bool TexelMap::addToTexel(glm::ivec2 texel, const MapPlace& place, const MapSurface& surface,
                          const glm::dvec3& watts) {
    const std::size_t i = index(texel);
    if (!takes(_texels[i], glm::dvec2(texel) + 0.5, {place.x, place.y}, place.z, surface)) return false;
    // Where something covers a part of the texel, the same face may go on below it, unseen.
    if (_texels[i].share < 1 && !takes(cast(place), place, place, place.z, surface)) return false;
    for (std::size_t c = 0; c < 3; ++c)
        if (watts[int(c)] > 0)
            std::atomic_ref<std::int64_t>(_sums[3 * i + c])
                .fetch_add(_fixed.of(watts[int(c)]), std::memory_order_relaxed);
    return true;
}

double TexelMap::addPoint(const MapPlace& place, const MapSurface& surface, const glm::dvec3& watts) {
    // Not floor: a place far outside must not overflow an int.
    if (!(place.x >= 0 && place.y >= 0 && place.x < size().x && place.y < size().y)) return 1;
    return addToTexel({int(place.x), int(place.y)}, place, surface, watts) ? 0 : 1;
}

double TexelMap::addTriangle(const std::array<MapPlace, 3>& corners, const MapSurface& surface,
                             const glm::dvec3& watts) {
    const std::array<glm::dvec2, 3> flat{glm::dvec2(corners[0]), glm::dvec2(corners[1]),
                                         glm::dvec2(corners[2])};
    const glm::dvec2 first = glm::floor(flat[0]);
    if (first == glm::floor(flat[1]) && first == glm::floor(flat[2]))
        return addPoint((corners[0] + corners[1] + corners[2]) / 3.0, surface, watts);
    const glm::dvec2 a = flat[1] - flat[0], b = flat[2] - flat[0];
    const double area = 0.5 * std::abs(a.x * b.y - a.y * b.x);
    const double longest = std::max({glm::dot(a, a), glm::dot(b, b), glm::dot(b - a, b - a)});
    double lost = 0;
    if (!(area > 1e-12 * longest)) { // a focus: a line has no area to go by
        constexpr int pieces = 16;
        for (int i = 0; i < pieces; ++i) {
            const double s = 2 * (i + 0.5) / pieces;
            const MapPlace at =
                s < 1 ? glm::mix(corners[0], corners[1], s) : glm::mix(corners[1], corners[2], s - 1);
            lost += addPoint(at, surface, watts / double(pieces)) / pieces;
        }
        return lost;
    }
    const double within = overlaps(flat, size(), [&](int x, int y, double piece, const glm::dvec2& at) {
        const double depth = corners[0].z + glm::dot(surface.gradient, at - flat[0]) * texel();
        if (!addToTexel({x, y}, {at.x, at.y, depth}, surface, watts * (piece / area))) lost += piece / area;
    });
    return lost + std::max(1 - within / area, 0.0);
}

void TexelMap::closeBatch() {
    ++_batches;
    for (std::size_t i = 0; i < _texels.size(); ++i) {
        const double sum = _fixed.watts(_sums[3 * i] + _sums[3 * i + 1] + _sums[3 * i + 2]) / 3;
        const double added = sum - _before[i];
        _squares[i] += added * added;
        _before[i] = sum;
    }
}

double TexelMap::surfaceArea(const Texel& texel) const {
    return _request.frame.texelArea() * double(texel.share) / double(texel.facing);
}

TexelMap::Finished TexelMap::finished() const {
    const std::size_t count = _texels.size();
    Finished map{std::vector<float>(3 * count), std::vector<float>(4 * count), std::vector<float>(3 * count),
                 0, 0};
    double deviations = 0, whole = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const Texel& texel = _texels[i];
        if (texel.facing == 0) continue;
        const double area = surfaceArea(texel);
        const glm::dvec2 at(double(i % std::size_t(size().x)) + 0.5, double(i / std::size_t(size().x)) + 0.5);
        const glm::dvec3 p = _box.point({at * this->texel(), double(texel.depth)});
        for (std::size_t c = 0; c < 3; ++c) {
            map.irradiance[3 * i + c] = float(_fixed.watts(_sums[3 * i + c]) / area);
            map.position[4 * i + c] = float(p[int(c)]);
            map.normal[3 * i + c] = texel.normal[int(c)];
            map.deposited += double(map.irradiance[3 * i + c]) * area / 3;
        }
        map.position[4 * i + 3] = 1;
        whole += _before[i] / area;
        const double variance =
            (_squares[i] - _before[i] * _before[i] / _batches) / std::max(_batches - 1, 1);
        deviations += std::sqrt(std::max(variance, 0.0) * _batches) / area;
    }
    // The mean distance of a normal number from its mean is √(2/π) of its deviation.
    if (whole > 0 && _batches > 1)
        map.standardError = std::sqrt(2 / std::numbers::pi) / deviationBias(_batches) * deviations / whole;
    return map;
}

} // namespace limpid::reference
