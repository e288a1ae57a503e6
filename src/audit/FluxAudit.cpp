#include "audit/FluxAudit.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "reference/FaceSorting.h"
#include "reference/Parallel.h"
#include "reference/Random.h"
#include "reference/Source.h"
#include "scene/MethodFacts.h"

namespace limpid {

namespace {

double meanOf(const glm::dvec3& rgb) {
    return (rgb.x + rgb.y + rgb.z) / 3;
}

/// What becomes of the light of a ray that no map has, W for a ray of one unit of flux, mean of R, G and B.
struct Lost {
    double missed = 0, rejected = 0, absorbed = 0, scattered = 0;

    double sum() const { return missed + rejected + absorbed + scattered; }
    /// Each by itself, and the sum, which the residual hangs on.
    std::array<double, 5> figures() const { return {missed, rejected, absorbed, scattered, sum()}; }
};

/// The maps of a receiver by facing; null where there is none.
using Maps = std::array<const ShownSurface*, 5>;

/// Follows the rays of one light.
class RayTracer {
  public:
    RayTracer(const reference::SceneGeometry& geometry, const Water& water, const BeamRays& beams,
              const reference::Source& source, std::span<const ShownSurface> maps)
        : _geometry(geometry), _absorption(water.absorption), _scattering(water.scattering), _beams(beams),
          _source(source) {
        for (const ShownSurface& map : maps) {
            _maps.resize(std::max(_maps.size(), std::size_t(map.receiver) + 1));
            _maps[std::size_t(map.receiver)][std::size_t(map.facing)] = &map;
        }
    }

    /// One ray in each of `count` equal parts of the flux, in their order.
    std::vector<Lost> follow(int count) const {
        constexpr int atOnce = 1024;
        std::vector<Lost> lost(static_cast<std::size_t>(count));
        reference::inParallel((count + atOnce - 1) / atOnce, reference::threadsOf(0), [&](int, int piece) {
            for (int i = piece * atOnce; i < std::min(count, (piece + 1) * atOnce); ++i)
                lost[std::size_t(i)] = follow(rayOf(i, count));
        });
        return lost;
    }

  private:
    BeamRay rayOf(int i, int count) const;
    Lost follow(const BeamRay& ray) const;
    double share(const reference::Hit& hit, const glm::dvec3& direction) const;

    const reference::SceneGeometry& _geometry;
    glm::dvec3 _absorption, _scattering; ///< 1/m
    const BeamRays& _beams;
    const reference::Source& _source;
    std::vector<Maps> _maps; ///< of each receiver
};

/// Where things above the water take a part of a triangle's light, the ray is one that they leave.
BeamRay RayTracer::rayOf(int i, int count) const {
    constexpr int tries = 16;
    const std::uint64_t random = reference::mixed(std::uint64_t(count), std::uint64_t(i));
    const BeamRay drawn = _beams.at((i + reference::unit(random)) / count);
    BeamRay ray = drawn;
    for (int k = 1; k <= tries && _beams.lit(drawn.triangle) < 1; ++k) {
        const glm::dvec3 up = -_source.incident(ray.from);
        const double distance = _source.point ? glm::distance(ray.from, _source.position) : 1e30;
        if (!_geometry.blocked(ray.from, up, distance)) return ray;
        ray = _beams.within(drawn.triangle, reference::unit(reference::mixed(random, std::uint64_t(k))));
    }
    return drawn;
}

/// The share of what lands at `hit` that a map has.
double RayTracer::share(const reference::Hit& hit, const glm::dvec3& direction) const {
    if (std::size_t(hit.receiver) >= _maps.size() || !hit.shown) return 0;
    const Maps& maps = _maps[std::size_t(hit.receiver)];
    if (!maps[0]) return 0;
    const glm::dvec3 lit = glm::dot(hit.normal, direction) > 0 ? -hit.normal : hit.normal;
    const reference::FaceSorting& faces = maps[0]->faces;
    const ShownSurface* map = maps[std::size_t(faces.mapOf(faces.sheet ? lit : hit.normal))];
    if (!map || glm::dot(lit, map->frame.box.t) >= 0) return 0;
    return map->share(hit, _geometry);
}

/// On through sheets, each of which takes its share.
Lost RayTracer::follow(const BeamRay& ray) const {
    const glm::dvec3 taken = _absorption + _scattering;
    Lost lost;
    glm::dvec3 watts = _source.strength;
    double travelled = 0;
    reference::Hit hit = _geometry.first(ray.from, ray.direction);
    for (int sheets = 0; hit && sheets <= reference::mostSheets; ++sheets) {
        const glm::dvec3 arriving = watts * glm::exp(-taken * std::max(hit.distance - travelled, 0.0));
        const glm::dvec3 gone = (watts - arriving) / glm::max(taken, glm::dvec3(1e-300));
        lost.absorbed += meanOf(gone * _absorption);
        lost.scattered += meanOf(gone * _scattering);
        lost.rejected += (1 - share(hit, ray.direction)) * meanOf(arriving * (1.0 - hit.transmittance));
        watts = arriving * hit.transmittance;
        travelled = hit.distance;
        if (watts == glm::dvec3(0)) return lost;
        hit = _geometry.next(ray.from, ray.direction, hit);
    }
    lost.missed += meanOf(watts);
    return lost;
}

/// The greatest standard error of any figure's mean over rays drawn one from each of equal parts: neighbours
/// differ by what one part has of spread, or more.
double standardError(std::span<const Lost> rays) {
    std::array<double, 5> squares{};
    for (std::size_t i = 1; i < rays.size(); ++i) {
        const auto here = rays[i].figures(), before = rays[i - 1].figures();
        for (std::size_t k = 0; k < squares.size(); ++k)
            squares[k] += 0.5 * (here[k] - before[k]) * (here[k] - before[k]);
    }
    return std::sqrt(*std::max_element(squares.begin(), squares.end())) / double(rays.size());
}

/// How many rays bring `error` down to `wanted`: by places along lines where light ends, of which a strip as
/// wide as the rays stand apart is in doubt.
int raysFor(int count, double error, double wanted) {
    const double more = 1.2 * count * std::pow(error / wanted, 4.0 / 3.0);
    return int(std::min(more, double(FluxAudit::mostRays)));
}

ShownSurface shownSurface(const Engine& engine, const MapWork& maps, const MapData& data) {
    TexelFrame frame = maps.level.frame;
    frame.box.corner -= engine.origin();
    ShownSurface shown{maps.plan.receiver,
                       maps.level.facing,
                       reference::sortingOf(*maps.plan.facings),
                       frame,
                       engine.scene().water.level - engine.origin().y,
                       data.position,
                       data.normal,
                       data.coverage,
                       {}};
    if (factsOf(engine.scene().caustics.method).occludesPerBeam) return shown;
    // A method that shades by the mean light takes a texel's light by the share of it that arrives there.
    const auto colour = maps.level.diffuse.readFloats(GL_RGBA, 4);
    for (std::size_t i = 3; i < colour.size(); i += 4)
        shown.taken.push_back(colour[i]);
    return shown;
}

} // namespace

FluxAudit::FluxAudit(const Scene& scene, const glm::dvec3& origin)
    : _scene(scene), _origin(origin), _geometry(scene, origin) {}

FluxBalance FluxAudit::count(const BeamRays& beams, int light, std::span<const ShownSurface> maps) const {
    FluxBalance balance;
    const reference::Source source =
        reference::sourceOf(_scene.lights[std::size_t(light)], _origin, glm::dvec2(0));
    balance.entering = beams.flux() * meanOf(source.strength);
    if (!(balance.entering > 0)) return balance;
    const RayTracer tracer(_geometry, _scene.water, beams, source, maps);
    const double wanted = wantedError * meanOf(source.strength);
    std::vector<Lost> lost = tracer.follow(leastRays);
    if (const double error = standardError(lost); error > wanted)
        lost = tracer.follow(raysFor(leastRays, error, wanted));
    const double perRay = beams.flux() / double(lost.size());
    for (const Lost& ray : lost) {
        balance.missed += perRay * ray.missed;
        balance.rejected += perRay * ray.rejected;
        balance.absorbed += perRay * ray.absorbed;
        balance.scattered += perRay * ray.scattered;
    }
    balance.standardError = beams.flux() * standardError(lost);
    balance.rays = std::int64_t(lost.size());
    return balance;
}

std::vector<FluxBalance> auditFlux(const Engine& engine, std::span<const MapData> maps) {
    const FluxAudit audit(engine.scene(), engine.origin());
    std::vector<FluxBalance> balances;
    for (int light = 0; light < int(engine.scene().lights.size()); ++light) {
        FluxBalance& balance = balances.emplace_back();
        const LightWork& state = engine.light(light);
        if (state.beams.strength == glm::dvec3(0)) continue;
        std::vector<ShownSurface> shown;
        for (std::size_t i = 0; i < maps.size(); ++i)
            if (engine.maps()[i].plan.light == light)
                shown.push_back(shownSurface(engine, engine.maps()[i], maps[i]));
        balance = audit.count(readBeams(state.mapBeams(), engine.mapMesh(state)), light, shown);
        for (std::size_t i = 0; i < maps.size(); ++i)
            if (engine.maps()[i].plan.light == light) balance.deposited += maps[i].deposited;
    }
    return balances;
}

} // namespace limpid
