#include "reference/CellTracer.h"

#include <algorithm>
#include <cmath>

#include "reference/Refraction.h"

namespace limpid::reference {

namespace {

double meanOf(const glm::dvec3& rgb) {
    return (rgb.x + rgb.y + rgb.z) / 3;
}

/// A ray must end this many times as far off a group's surface as corners may, to have met something else:
/// what is just smooth enough for the corners shall not count as hidden from them.
constexpr double hiddenSlack = 4;

using Half = std::array<glm::ivec2, 3>;

/// The corners of one half of a cell, counter-clockwise from above. `falling`: which way the diagonal runs.
Half halfOf(glm::ivec2 at, bool upper, bool falling) {
    const glm::ivec2 x(1, 0), z(0, 1), both(1, 1);
    if (falling) return upper ? Half{at + both, at + x, at + z} : Half{at, at + z, at + x};
    return upper ? Half{at + z, at + both, at} : Half{at + x, at, at + both};
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
    traced.map = nullptr;
    traced.fate = Fate::Dark;
    if (!ray.facing || !_scene.shade.lit(*_source, ray.from)) return;
    traced.hit = _scene.geometry.first(ray.from, ray.direction);
    traced.fate = traced.hit ? Fate::Landed : Fate::Missed;
    if (!traced.hit) return;
    const auto& maps = _scene.maps[std::size_t(traced.hit.receiver)];
    if (!maps[0]) return;
    const glm::dvec3& normal = traced.hit.normal;
    const glm::dvec3 lit = glm::dot(normal, ray.direction) > 0 ? -normal : normal;
    const FaceSorting& faces = maps[0]->request().faces;
    TexelMap* map = maps[std::size_t(faces.mapOf(faces.sheet ? lit : normal))];
    if (map && glm::dot(lit, map->axis()) < 0) traced.map = map;
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
    const double extent = extentOf(at, count);
    const bool one = agree(*corners[0], *corners[1], extent) && agree(*corners[0], *corners[2], extent) &&
                     agree(*corners[1], *corners[3], extent) && agree(*corners[2], *corners[3], extent);
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
    if (!agree(*corners[0], sample, extent, hiddenSlack))
        settleOnHidden(at, count, sample);
    else if (sample.map)
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

/// How far apart the corners of a group of cells land, m.
double CellTracer::extentOf(glm::ivec2 at, int count) const {
    const Traced &a = cornerOf(at), &b = cornerOf(at + count);
    const Traced &c = cornerOf(at + glm::ivec2(count, 0)), &d = cornerOf(at + glm::ivec2(0, count));
    const auto apart = [](const Traced& p, const Traced& q) {
        return glm::length(glm::cross(q.hit.point - p.hit.point, q.ray.direction));
    };
    return std::max(apart(a, b), apart(c, d));
}

/// Whether two rays of a group end alike. `extent`: of the group; `slack` times the usual step is no step.
bool CellTracer::agree(const Traced& a, const Traced& b, double extent, double slack) const {
    if (a.fate != b.fate) return false;
    if (a.fate != Fate::Landed) return true;
    if (a.hit.receiver != b.hit.receiver || a.map != b.map) return false;
    return !a.map || (smooth(a, b, extent, slack) && smooth(b, a, extent, slack));
}

/// Whether the face that `a` hit, gone on with, comes close enough to where `b` hit: the footprint between
/// them then has no step, and lies within a fifth of a texel of where it belongs.
bool CellTracer::smooth(const Traced& a, const Traced& b, double extent, double slack) const {
    const double facing = glm::dot(a.hit.normal, b.ray.direction);
    if (std::abs(facing) < 1e-3 || (facing > 0) != (glm::dot(a.hit.normal, a.ray.direction) > 0))
        return false;
    const double step = std::abs(glm::dot(a.hit.normal, b.hit.point - a.hit.point) / facing);
    if (glm::distance(a.map->gradient(a.hit.normal), a.map->gradient(b.hit.normal)) > mostCrease)
        return false;
    if (step > slack * 0.5 * extent + 1e-9 * b.hit.distance) return false;
    const double aside = step * glm::length(glm::cross(b.ray.direction, a.map->axis()));
    return aside <= slack * 0.2 * a.map->texel();
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
    const double extent = extentOf(at, count);
    const glm::dvec2 start = unitSquare(randomOf(at, 16 + count));
    std::vector<Traced> found{sample};
    for (int i = 0; i < rays; ++i) {
        const Traced other = traceAt(at, count, spread(start, i));
        if (!agree(cornerOf(at), other, extent, hiddenSlack)) found.push_back(other);
    }
    _tally.photons += rays;
    const double flux = groupFlux(at, count) / double(found.size());
    for (const Traced& traced : found)
        land(traced, flux);
}

/// After Fresnel, in m² or sr.
double CellTracer::cellFlux(glm::ivec2 at, bool upper) const {
    const Half half = halfOf(at, upper, _seed & 1);
    const auto ray = [&](std::size_t i) -> const Ray& { return cornerOf(half[i]).ray; };
    const double through = _source->through(ray(0).from, ray(1).from, ray(2).from);
    return std::max(through, 0.0) * (ray(0).transmittance + ray(1).transmittance + ray(2).transmittance) / 3;
}

/// Everything lands on the face that the map sees best of those that were met, or for a curved receiver on a
/// sheet through where the corners landed.
CellTracer::Landings CellTracer::landingsOf(glm::ivec2 at, int count, const Traced& sample) const {
    const TexelMap& map = *sample.map;
    std::array<const Traced*, 5> met{&sample};
    for (int i = 0; i < 4; ++i)
        met[std::size_t(i) + 1] = &cornerOf(at + count * glm::ivec2(i % 2, i / 2));
    const auto facing = [&](const Traced* traced) {
        return std::abs(glm::dot(traced->hit.normal, map.axis()));
    };
    const Hit& face = (*std::max_element(met.begin(), met.end(), [&](const Traced* a, const Traced* b) {
                          return facing(a) < facing(b);
                      }))->hit;
    const auto toFace = [&](const Ray& ray) {
        return glm::dot(face.normal, face.point - ray.from) / glm::dot(face.normal, ray.direction);
    };
    std::array<double, 4> lift;
    for (std::size_t i = 0; i < 4; ++i)
        lift[i] = met[i + 1]->hit.distance - toFace(met[i + 1]->ray);
    const auto [least, most] = std::minmax_element(lift.begin(), lift.end());
    Landings landings;
    landings.surface = {map.gradient(face.normal), 2 * (std::max(*most, 0.0) - std::min(*least, 0.0)), true};
    for (int y = 0; y <= count; ++y)
        for (int x = 0; x <= count; ++x) {
            const Ray& ray = cornerOf(at + glm::ivec2(x, y)).ray;
            const double s = double(x) / count, t = double(y) / count;
            const double distance =
                toFace(ray) + glm::mix(glm::mix(lift[0], lift[1], s), glm::mix(lift[2], lift[3], s), t);
            const std::size_t i = landings.index({x, y});
            landings.places[i] = map.place(ray.from + distance * ray.direction);
            landings.left[i] = remaining(distance);
        }
    return landings;
}

void CellTracer::deposit(glm::ivec2 at, int count, const Traced& sample) {
    const Landings landings = landingsOf(at, count, sample);
    for (int y = 0; y < count; ++y)
        for (int x = 0; x < count; ++x)
            for (const bool upper : {false, true}) {
                const glm::dvec3 watts = _source->strength * cellFlux(at + glm::ivec2(x, y), upper);
                const Half half = halfOf({x, y}, upper, _seed & 1);
                std::array<MapPlace, 3> corners;
                glm::dvec3 share(0);
                for (std::size_t c = 0; c < 3; ++c) {
                    corners[c] = landings.places[landings.index(half[c])];
                    share += landings.left[landings.index(half[c])] / 3.0;
                }
                const glm::dvec3 arriving = watts * share;
                _tally.entering += _scene.fixed.of(meanOf(watts));
                countLost(watts - arriving);
                const double lost = sample.map->addTriangle(corners, landings.surface, arriving);
                _tally.rejected += _scene.fixed.of(lost * meanOf(arriving));
            }
    _tally.photons += count * count;
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
    for (int i = 0; i < 4; ++i) {
        const Traced& landed = cornerOf(at + glm::ivec2(i % 2, i / 2));
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

void CellTracer::land(const Traced& traced, double flux) {
    if (traced.fate == Fate::Dark) return;
    const glm::dvec3 watts = _source->strength * flux;
    _tally.entering += _scene.fixed.of(meanOf(watts));
    if (traced.fate == Fate::Missed) {
        _tally.missed += _scene.fixed.of(meanOf(watts));
        return;
    }
    const glm::dvec3 arriving = watts * remaining(traced.hit.distance);
    countLost(watts - arriving);
    const double lost = traced.map ? traced.map->addPoint(traced.map->place(traced.hit.point),
                                                          {traced.map->gradient(traced.hit.normal)}, arriving)
                                   : 1;
    _tally.rejected += _scene.fixed.of(lost * meanOf(arriving));
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
