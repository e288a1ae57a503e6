#include "reference/CellTracer.h"

#include <algorithm>
#include <cmath>

#include "reference/Refraction.h"

namespace limpid::reference {

namespace {

/// A ray must end this many times as far off a group's surface as corners may, to have met something else:
/// what is just smooth enough for the corners shall not count as hidden from them.
constexpr double hiddenSlack = 4;

/// Shares of light that differ by more are told apart within a group.
constexpr double mostShareStep = 0.02;

bool alike(const glm::dvec3& a, const glm::dvec3& b) {
    return glm::all(glm::lessThanEqual(glm::abs(a - b), glm::dvec3(mostShareStep)));
}

} // namespace

void Tally::add(const Tally& other) {
    entering += other.entering;
    absorbed += other.absorbed;
    scattered += other.scattered;
    missed += other.missed;
    rejected += other.rejected;
    photons += other.photons;
}

CellTracer::CellTracer(const LightScene& scene, Tally& tally)
    : _scene(scene), _tally(tally), _extinction(scene.absorption + scene.scattering),
      _corners((tile + 1) * (tile + 1)) {}

CellTracer::Ray CellTracer::enter(const glm::dvec2& place) const {
    const Surface::Point surface = _scene.surface.at(place);
    Ray ray;
    ray.from = {place.x, _scene.level + surface.height, place.y};
    const glm::dvec3 up = surface.up(), incident = _source->incident(ray.from);
    const double cosIncident = -glm::dot(up, incident);
    if (cosIncident <= 0) return ray;
    ray.facing = true;
    ray.transmittance = transmitted(std::min(cosIncident, 1.0), _scene.ior) * _source->withinCone(incident);
    ray.direction = refracted(incident, up, _scene.ior);
    return ray;
}

void CellTracer::follow(Traced& traced) const {
    const Ray& ray = traced.ray;
    traced.landings.clear();
    traced.fate = Fate::Dark;
    traced.lit = ray.facing ? _scene.shade.lit(*_source, ray.from) : glm::dvec3(0);
    if (traced.lit == glm::dvec3(0)) return;
    traced.fate = Fate::Missed;
    Hit hit = _scene.geometry.first(ray.from, ray.direction);
    while (hit) {
        if (traced.landings.size() + 1 == mostSheets) hit.transmittance = glm::dvec3(0);
        traced.landings.push_back({hit, mapOf(hit, ray.direction)});
        if (hit.transmittance == glm::dvec3(0)) {
            traced.fate = Fate::Landed;
            return;
        }
        hit = _scene.geometry.next(ray.from, ray.direction, hit);
    }
}

TexelMap* CellTracer::mapOf(const Hit& hit, const glm::dvec3& direction) const {
    const auto& maps = _scene.maps[std::size_t(hit.receiver)];
    if (!maps[0] || !hit.shown) return nullptr;
    const glm::dvec3 lit = glm::dot(hit.normal, direction) > 0 ? -hit.normal : hit.normal;
    const FaceSorting& faces = maps[0]->request().faces;
    TexelMap* map = maps[std::size_t(faces.mapOf(faces.sheet ? lit : hit.normal))];
    return map && glm::dot(lit, map->axis()) < 0 ? map : nullptr;
}

CellTracer::Traced& CellTracer::corner(int x, int y) {
    return _corners[std::size_t(y * (tile + 1) + x)];
}
const CellTracer::Traced& CellTracer::cornerOf(glm::ivec2 at) const {
    return _corners[std::size_t(at.y * (tile + 1) + at.x)];
}

void CellTracer::trace(const CellGrid& grid, const Source& source, glm::ivec2 at) {
    _source = &source;
    _first = at * tile;
    _cells = glm::min(grid.count - _first, tile);
    _seed = mixed(grid.seed, std::uint64_t(_first.y) << 32 | std::uint64_t(_first.x));
    for (int i = 0; i <= _cells.x; ++i)
        _x[std::size_t(i)] = grid.line(0, _first.x + i);
    for (int i = 0; i <= _cells.y; ++i)
        _z[std::size_t(i)] = grid.line(1, _first.y + i);
    for (int y = 0; y <= _cells.y; ++y)
        for (int x = 0; x <= _cells.x; ++x) {
            corner(x, y).ray = enter({_x[std::size_t(x)], _z[std::size_t(y)]});
            corner(x, y).fate = Fate::Untraced;
        }
    for (int y = 0; y < _cells.y; y += group)
        for (int x = 0; x < _cells.x; x += group)
            traceCells({x, y}, group);
}

void CellTracer::traceCells(glm::ivec2 at, int count) {
    const std::array<Traced*, 4> corners{&corner(at.x, at.y), &corner(at.x + count, at.y),
                                         &corner(at.x, at.y + count), &corner(at.x + count, at.y + count)};
    for (Traced* traced : corners)
        if (traced->fate == Fate::Untraced) follow(*traced);
    const Extents extents = extentsOf(at, count);
    const bool one = agree(*corners[0], *corners[1], extents) && agree(*corners[0], *corners[2], extents) &&
                     agree(*corners[1], *corners[3], extents) && agree(*corners[2], *corners[3], extents);
    if (!one && count == 1) return plainPhotons(at);
    if (!one) {
        const int half = count / 2;
        for (int i = 0; i < 4; ++i)
            traceCells(at + half * glm::ivec2(i % 2, i / 2), half);
        return;
    }
    // Where all corners agree, one ray at random decides for the whole group: what is too small to meet a
    // corner gets its share of the light in the mean.
    const Traced sample = traceAt(at, count, unitSquare(randomOf(at, count)));
    const auto& landings = sample.landings;
    if (!agree(*corners[0], sample, extents, hiddenSlack))
        settleOnHidden(at, count, sample);
    else if (std::any_of(landings.begin(), landings.end(), [](const Landing& l) { return l.map; }))
        deposit(at, count, sample);
    else
        settleAtOnce(at, count, sample);
}

/// A ray at `share` of the way through the cells from `at`.
CellTracer::Traced CellTracer::traceAt(glm::ivec2 at, int count, const glm::dvec2& share) const {
    const glm::dvec2 low(_x[std::size_t(at.x)], _z[std::size_t(at.y)]),
        high(_x[std::size_t(at.x + count)], _z[std::size_t(at.y + count)]);
    Traced traced;
    traced.ray = enter(glm::mix(low, high, share));
    follow(traced);
    return traced;
}

CellTracer::Extents CellTracer::extentsOf(glm::ivec2 at, int count) const {
    const Traced &a = cornerOf(at), &b = cornerOf(at + count);
    const Traced &c = cornerOf(at + glm::ivec2(count, 0)), &d = cornerOf(at + glm::ivec2(0, count));
    Extents extents{};
    const std::size_t shared =
        std::min({a.landings.size(), b.landings.size(), c.landings.size(), d.landings.size()});
    for (std::size_t i = 0; i < shared; ++i) {
        const auto apart = [i](const Traced& p, const Traced& q) {
            return glm::length(
                glm::cross(q.landings[i].hit.point - p.landings[i].hit.point, q.ray.direction));
        };
        extents[i] = std::max(apart(a, b), apart(c, d));
    }
    return extents;
}

/// Whether two rays of a group end alike. `slack` times the usual step is no step.
bool CellTracer::agree(const Traced& a, const Traced& b, const Extents& extents, double slack) const {
    if (a.fate != b.fate || a.landings.size() != b.landings.size() || !alike(a.lit, b.lit)) return false;
    for (std::size_t i = 0; i < a.landings.size(); ++i) {
        const Landing &p = a.landings[i], &q = b.landings[i];
        if (p.hit.receiver != q.hit.receiver || p.map != q.map ||
            !alike(p.hit.transmittance, q.hit.transmittance))
            return false;
        if (p.map && !(smooth(a, b, i, extents[i], slack) && smooth(b, a, i, extents[i], slack)))
            return false;
    }
    return true;
}

/// Whether the face that `a` hit, gone on with, comes close enough to where `b` hit: the footprint between
/// them then has no step, and lies within a fifth of a texel of where it belongs.
bool CellTracer::smooth(const Traced& a, const Traced& b, std::size_t landing, double extent,
                        double slack) const {
    const Hit &from = a.landings[landing].hit, &to = b.landings[landing].hit;
    const TexelMap& map = *a.landings[landing].map;
    const double facing = glm::dot(from.normal, b.ray.direction);
    if (std::abs(facing) < 1e-3 || (facing > 0) != (glm::dot(from.normal, a.ray.direction) > 0)) return false;
    const double step = std::abs(glm::dot(from.normal, to.point - from.point) / facing);
    if (glm::distance(map.gradient(from.normal), map.gradient(to.normal)) > mostCrease) return false;
    if (step > slack * 0.5 * extent + 1e-9 * to.distance) return false;
    const double aside = step * glm::length(glm::cross(b.ray.direction, map.axis()));
    return aside <= slack * 0.2 * map.texel();
}

double CellTracer::groupFlux(glm::ivec2 at, int count) const {
    double flux = 0;
    for (int y = 0; y < count; ++y)
        for (int x = 0; x < count; ++x)
            for (const bool upper : {false, true})
                flux += cellFlux(at + glm::ivec2(x, y), upper);
    return flux;
}

void CellTracer::settleAtOnce(glm::ivec2 at, int count, const Traced& sample) {
    _tally.photons += count * count;
    land(sample, groupFlux(at, count));
}

/// The sample met something that no corner did. It takes all of the group's light, as often as it is met: its
/// due in the mean. More rays say where on it.
void CellTracer::settleOnHidden(glm::ivec2 at, int count, const Traced& sample) {
    constexpr int rays = 64;
    const Extents extents = extentsOf(at, count);
    const glm::dvec2 start = unitSquare(randomOf(at, 16 + count));
    std::vector<Traced> found{sample};
    for (int i = 0; i < rays; ++i) {
        const Traced other = traceAt(at, count, spread(start, i));
        if (!agree(cornerOf(at), other, extents, hiddenSlack)) found.push_back(other);
    }
    _tally.photons += rays;
    const double flux = groupFlux(at, count) / double(found.size());
    for (const Traced& traced : found)
        land(traced, flux);
}

double CellTracer::cellArea(glm::ivec2 at) const {
    return (_x[std::size_t(at.x) + 1] - _x[std::size_t(at.x)]) *
           (_z[std::size_t(at.y) + 1] - _z[std::size_t(at.y)]);
}

std::uint64_t CellTracer::randomOf(glm::ivec2 at, int use) const {
    return mixed(_seed, std::uint64_t((at.y * tile + at.x) * 32 + use));
}

/// So many that each texel gets its share of them over all grids.
int CellTracer::plainCount(glm::ivec2 at) const {
    double texels = 0;
    for (int i = 0; i < 4; ++i)
        for (const Landing& landed : cornerOf(at + glm::ivec2(i % 2, i / 2)).landings) {
            if (!landed.map) continue;
            // What the cell lights there, if all of it came as far.
            std::array<glm::dvec3, 4> ends;
            for (int k = 0; k < 4; ++k) {
                const Ray& ray = cornerOf(at + glm::ivec2(k % 2, k / 2)).ray;
                ends[std::size_t(k)] = ray.from + landed.hit.distance * ray.direction;
            }
            const double area = 0.5 * glm::length(glm::cross(ends[3] - ends[0], ends[2] - ends[1]));
            texels = std::max(texels, area / (landed.map->texel() * landed.map->texel()));
        }
    constexpr double least = 4, most = 256;
    return int(std::clamp(std::ceil(_scene.photonsPerTexel * texels), least, most));
}

void CellTracer::plainPhotons(glm::ivec2 at) {
    const glm::dvec2 start = unitSquare(randomOf(at, 0));
    const int count = plainCount(at);
    const double area = cellArea(at) / count;
    for (int i = 0; i < count; ++i) {
        const Traced photon = traceAt(at, 1, spread(start, i));
        if (photon.fate == Fate::Dark) continue;
        const glm::dvec3& from = photon.ray.from;
        const double density = _source->density(from, _scene.surface.at({from.x, from.z}).slope);
        land(photon, std::max(density, 0.0) * area * photon.ray.transmittance);
    }
    _tally.photons += count;
}

} // namespace limpid::reference
