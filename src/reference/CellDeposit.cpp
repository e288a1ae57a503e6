// What light that a CellTracer follows leaves where: on faces, in the water, beyond.
#include "reference/CellTracer.h"

#include <algorithm>
#include <cmath>

namespace limpid::reference {

namespace {

double meanOf(const glm::dvec3& rgb) {
    return (rgb.x + rgb.y + rgb.z) / 3;
}

/// Mean of three corners.
template <typename Values>
glm::dvec3 meanAt(const Values& values, const std::array<std::size_t, 3>& corners) {
    return (values[corners[0]] + values[corners[1]] + values[corners[2]]) / 3.0;
}

/// Corners (0, 0), (1, 0), (0, 1) and (1, 1).
template <typename T>
T bilinear(const std::array<T, 4>& corners, double s, double t) {
    return glm::mix(glm::mix(corners[0], corners[1], s), glm::mix(corners[2], corners[3], s), t);
}

using Half = std::array<glm::ivec2, 3>;

/// The corners of one half of a cell, counter-clockwise from above. `falling`: which way the diagonal runs.
Half halfOf(glm::ivec2 at, bool upper, bool falling) {
    const glm::ivec2 x(1, 0), z(0, 1), both(1, 1);
    if (falling) return upper ? Half{at + both, at + x, at + z} : Half{at, at + z, at + x};
    return upper ? Half{at + z, at + both, at} : Half{at + x, at, at + both};
}

} // namespace

/// After Fresnel, in m² or sr.
double CellTracer::cellFlux(glm::ivec2 at, bool upper) const {
    const Half half = halfOf(at, upper, _seed & 1);
    const auto ray = [&](std::size_t i) -> const Ray& { return cornerOf(half[i]).ray; };
    const double through = _source->through(ray(0).from, ray(1).from, ray(2).from);
    return std::max(through, 0.0) * (ray(0).transmittance + ray(1).transmittance + ray(2).transmittance) / 3;
}

/// Calls `visit(index, corner, s, t)` for the corners of a group of cells; s and t in [0, 1].
template <typename Visit>
void CellTracer::forEachCorner(int count, const Visit& visit) {
    for (int y = 0; y <= count; ++y)
        for (int x = 0; x <= count; ++x)
            visit(cornerIndex({x, y}), glm::ivec2(x, y), double(x) / count, double(y) / count);
}

/// Everything lands on the face that the map sees best of those that were met, or for a curved receiver on a
/// sheet through where the corners landed. Without a map only distances count.
CellTracer::Landings CellTracer::landingsOf(glm::ivec2 at, int count, const Traced& sample,
                                            std::size_t landing) const {
    const TexelMap* map = sample.landings[landing].map;
    std::array<const Hit*, 4> hits;
    for (int i = 0; i < 4; ++i)
        hits[std::size_t(i)] = &cornerOf(at + count * glm::ivec2(i % 2, i / 2)).landings[landing].hit;
    const Hit* face = &sample.landings[landing].hit;
    for (const Hit* hit : hits)
        if (map &&
            std::abs(glm::dot(hit->normal, map->axis())) > std::abs(glm::dot(face->normal, map->axis())))
            face = hit;
    const auto toFace = [&](const Ray& ray) {
        return map ? glm::dot(face->normal, face->point - ray.from) / glm::dot(face->normal, ray.direction)
                   : 0;
    };
    std::array<double, 4> lift;
    std::array<glm::dvec3, 4> through;
    for (std::size_t i = 0; i < 4; ++i) {
        lift[i] = hits[i]->distance - toFace(cornerOf(at + count * glm::ivec2(i % 2, i / 2)).ray);
        through[i] = hits[i]->transmittance;
    }
    Landings landings;
    if (map) {
        const auto [least, most] = std::minmax_element(lift.begin(), lift.end());
        const double slack = 2 * (std::max(*most, 0.0) - std::min(*least, 0.0));
        landings.surface = {map->gradient(face->normal), slack, true};
    }
    forEachCorner(count, [&](std::size_t i, glm::ivec2 corner, double s, double t) {
        const Ray& ray = cornerOf(at + corner).ray;
        landings.distances[i] = toFace(ray) + bilinear(lift, s, t);
        landings.transmittance[i] = bilinear(through, s, t);
        if (map) landings.places[i] = map->place(ray.from + landings.distances[i] * ray.direction);
    });
    return landings;
}

/// Calls `visit(watts, corners)` for both halves of each cell: RGB that come to the surface, and the indices
/// of the corners.
template <typename Visit>
void CellTracer::forEachHalf(glm::ivec2 at, int count, const Visit& visit) const {
    for (int y = 0; y < count; ++y)
        for (int x = 0; x < count; ++x)
            for (const bool upper : {false, true}) {
                const Half half = halfOf({x, y}, upper, _seed & 1);
                visit(_source->strength * cellFlux(at + glm::ivec2(x, y), upper),
                      std::array{cornerIndex(half[0]), cornerIndex(half[1]), cornerIndex(half[2])});
            }
}

void CellTracer::deposit(glm::ivec2 at, int count, const Traced& sample) {
    Going going;
    std::array<glm::dvec3, 4> lit;
    for (int i = 0; i < 4; ++i)
        lit[std::size_t(i)] = cornerOf(at + count * glm::ivec2(i % 2, i / 2)).lit;
    forEachCorner(
        count, [&](std::size_t i, glm::ivec2, double s, double t) { going.shares[i] = bilinear(lit, s, t); });
    forEachHalf(at, count, [&](const glm::dvec3& watts, const auto& corners) {
        _tally.entering += _scene.fixed.of(meanOf(watts * meanAt(going.shares, corners)));
    });
    for (std::size_t i = 0; i < sample.landings.size(); ++i)
        depositOn(at, count, sample, i, going);
    if (sample.fate == Fate::Missed)
        forEachHalf(at, count, [&](const glm::dvec3& watts, const auto& corners) {
            _tally.missed += _scene.fixed.of(meanOf(watts * meanAt(going.shares, corners)));
        });
    _tally.photons += count * count;
}

/// What the water takes on the way to a landing, and what that takes; `going` goes on behind it.
void CellTracer::depositOn(glm::ivec2 at, int count, const Traced& sample, std::size_t landing,
                           Going& going) {
    const Landings landings = landingsOf(at, count, sample, landing);
    TexelMap* map = sample.landings[landing].map;
    Shares gone, taken;
    forEachCorner(count, [&](std::size_t i, glm::ivec2, double, double) {
        const glm::dvec3 arriving = going.shares[i] * remaining(landings.distances[i] - going.passed[i]);
        gone[i] = going.shares[i] - arriving;
        taken[i] = arriving * (1.0 - landings.transmittance[i]);
        going.shares[i] = arriving * landings.transmittance[i];
        going.passed[i] = landings.distances[i];
    });
    forEachHalf(at, count, [&](const glm::dvec3& watts, const auto& corners) {
        countLost(watts * meanAt(gone, corners));
        const glm::dvec3 landed = watts * meanAt(taken, corners);
        std::array<MapPlace, 3> places;
        for (std::size_t c = 0; c < 3; ++c)
            places[c] = landings.places[corners[c]];
        const double lost = map ? map->addTriangle(places, landings.surface, landed) : 1;
        _tally.rejected += _scene.fixed.of(lost * meanOf(landed));
    });
}

void CellTracer::land(const Traced& traced, double flux) {
    if (traced.fate == Fate::Dark) return;
    glm::dvec3 going = _source->strength * flux * traced.lit;
    _tally.entering += _scene.fixed.of(meanOf(going));
    double passed = 0;
    for (const auto& [hit, map] : traced.landings) {
        const glm::dvec3 arriving = going * remaining(hit.distance - passed);
        countLost(going - arriving);
        const glm::dvec3 taken = arriving * (1.0 - hit.transmittance);
        const double lost =
            map ? map->addPoint(map->place(hit.point), {map->gradient(hit.normal)}, taken) : 1;
        _tally.rejected += _scene.fixed.of(lost * meanOf(taken));
        going = arriving * hit.transmittance;
        passed = hit.distance;
    }
    if (traced.fate == Fate::Missed) _tally.missed += _scene.fixed.of(meanOf(going));
}

/// Beer and Lambert's law: the share of light that is left.
glm::dvec3 CellTracer::remaining(double distance) const {
    if (_extinction == glm::dvec3(0)) return glm::dvec3(1);
    return glm::exp(-_extinction * std::max(distance, 0.0));
}

/// Counts what the water took, by what took it.
void CellTracer::countLost(const glm::dvec3& gone) {
    const glm::dvec3 absorbed = gone * _scene.absorption / glm::max(_extinction, glm::dvec3(1e-300));
    const glm::dvec3 scattered = gone * _scene.scattering / glm::max(_extinction, glm::dvec3(1e-300));
    _tally.absorbed += _scene.fixed.of(meanOf(absorbed));
    _tally.scattered += _scene.fixed.of(meanOf(scattered));
}

} // namespace limpid::reference
