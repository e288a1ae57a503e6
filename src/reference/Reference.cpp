#include "reference/Reference.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

#include "reference/CellTracer.h"
#include "reference/Parallel.h"

namespace limpid::reference {

namespace {

/// Directions that a sun's disc is made of in each batch: strata of a square, `discSide` a side.
constexpr int discSide = 8;
/// Plain photons that a texel gets over all batches where cells straddle an edge.
constexpr int photonsAtEdges = 1024;

/// From the unit square to the unit disc, areas kept in proportion (Shirley and Chiu 1997).
glm::dvec2 discPlace(const glm::dvec2& square) {
    const glm::dvec2 p = 2.0 * square - 1.0;
    if (p == glm::dvec2(0)) return p;
    const bool flat = std::abs(p.x) > std::abs(p.y);
    const double radius = flat ? p.x : p.y;
    const double quarter = std::numbers::pi / 4;
    const double angle = flat ? quarter * p.y / p.x : 2 * quarter - quarter * p.x / p.y;
    return radius * glm::dvec2(std::cos(angle), std::sin(angle));
}

/// More watts than any sum can come to, over all of what the light sends through the patch.
double mostWatts(const TraceJob& job, const Light& light, const Surface& surface) {
    const glm::dvec3 strength = light.type == LightType::Point ? light.intensity : light.irradiance;
    const double most = std::max({strength.x, strength.y, strength.z});
    if (light.type == LightType::Point) return most * 4 * std::numbers::pi;
    return most * job.patchSize.x * job.patchSize.y * (1 + surface.steepest());
}

/// What one light sends through one subdivision of the surface.
struct Pass {
    CellGrid grid;
    Source source;

    glm::ivec2 tiles() const { return (grid.count + CellTracer::tile - 1) / CellTracer::tile; }
    int tileCount() const { return tiles().x * tiles().y; }
};

/// About `photons` square cells in the patch, by whole groups.
glm::ivec2 cellCount(const glm::dvec2& size, double photons) {
    const double across = std::sqrt(photons * size.x / size.y);
    const auto whole = [](double cells) {
        return CellTracer::group * int(std::clamp(std::round(cells / CellTracer::group), 1.0, 1e6));
    };
    return {whole(across), whole(photons / std::max(across, 1e-9))};
}

class Tracer {
  public:
    Tracer(const TraceJob& job, const TraceOptions& options)
        : _job(job), _options(options), _water(job.scene.water), _surface(_water, job.origin, job.time),
          _geometry(job.scene, job.origin), _level(_water.level - job.origin.y),
          _patchMin(job.patchMin - glm::dvec2(job.origin.x, job.origin.z)),
          _shade(_geometry, _surface, _level, _patchMin, _patchMin + job.patchSize),
          _threads(threadsOf(options.threads)) {}

    TraceResult run() {
        TraceResult result;
        result.maps.resize(_job.maps.size());
        for (std::size_t light = 0; light < _job.scene.lights.size(); ++light)
            result.lights.push_back(runLight(int(light), result.maps));
        return result;
    }

  private:
    TracedLight runLight(int light, std::vector<TexelMap::Finished>& finished);
    Pass pass(const Light& light, int batch, int number, int count) const;
    void runBatch(const LightScene& scene, const std::vector<Pass>& passes, std::vector<Tally>& tallies,
                  int tilesBefore, int tilesInAll) const;

    const TraceJob& _job;
    const TraceOptions& _options;
    const Water& _water;
    Surface _surface;
    SceneGeometry _geometry;
    double _level; ///< relative to the origin, as all that follows
    glm::dvec2 _patchMin;
    Shade _shade;
    int _threads;
};

/// Subdivision `number` of `count` in a batch, and the place in the sun's disc that its light comes from.
Pass Tracer::pass(const Light& light, int batch, int number, int count) const {
    const std::uint64_t seed = mixed(mixed(_options.seed, std::uint64_t(batch)), std::uint64_t(number));
    glm::dvec2 disc(0);
    if (count > 1)
        disc = discPlace((glm::dvec2(number % discSide, number / discSide) + unitSquare(mixed(seed, 2))) /
                         double(discSide));
    Pass pass{{}, sourceOf(light, _job.origin, disc)};
    // All subdivisions of all batches together are the light once.
    pass.source.strength /= double(batches * count);
    pass.grid.min = _patchMin;
    pass.grid.max = _patchMin + _job.patchSize;
    pass.grid.count = cellCount(_job.patchSize, double(_options.photons) / (batches * count));
    pass.grid.seed = seed;
    pass.grid.stretched = pass.source.point;
    pass.grid.foot = {pass.source.position.x, pass.source.position.z};
    pass.grid.height = pass.source.position.y - _level;
    return pass;
}

void Tracer::runBatch(const LightScene& scene, const std::vector<Pass>& passes, std::vector<Tally>& tallies,
                      int tilesBefore, int tilesInAll) const {
    std::vector<CellTracer> tracers;
    for (Tally& tally : tallies)
        tracers.emplace_back(scene, tally);
    const int tiles = passes[0].tileCount();
    inParallel(
        tiles * int(passes.size()), _threads,
        [&](int thread, int i) {
            const Pass& pass = passes[std::size_t(i / tiles)];
            const int tile = i % tiles, across = pass.tiles().x;
            tracers[std::size_t(thread)].trace(pass.grid, pass.source, {tile % across, tile / across});
        },
        [&](int begun) {
            if (_options.progress) _options.progress(tilesBefore + begun, tilesInAll);
        });
}

TracedLight Tracer::runLight(int index, std::vector<TexelMap::Finished>& finished) {
    const Light& light = _job.scene.lights[std::size_t(index)];
    const double most = mostWatts(_job, light, _surface);
    const Fixed fixed{most > 0 ? 0x1p60 / most : 1};
    const int passCount =
        light.type == LightType::Directional && light.angularDiameter > 0 ? discSide * discSide : 1;
    LightScene scene{
        _surface,          _geometry,         _shade, _level, _water.ior,
        _water.absorption, _water.scattering, fixed,  {},     double(photonsAtEdges) / (batches * passCount)};
    scene.maps.resize(_job.scene.receivers.size());
    std::vector<std::pair<std::size_t, std::unique_ptr<TexelMap>>> maps;
    for (std::size_t i = 0; i < _job.maps.size(); ++i) {
        const MapRequest& request = _job.maps[i];
        if (request.light != index) continue;
        TexelMap& map =
            *maps.emplace_back(i, std::make_unique<TexelMap>(request, _geometry, _job.origin, _level, fixed))
                 .second;
        inParallel(map.size().y, _threads, [&](int, int row) { map.see(row); });
        inParallel(map.size().y, _threads, [&](int, int row) { map.findRims(row); });
        scene.maps[std::size_t(request.receiver)][std::size_t(request.facing)] = &map;
    }
    std::vector<Tally> tallies(std::size_t(_threads), Tally{});
    for (int batch = 0; batch < batches && _job.lightEnters[std::size_t(index)] && most > 0; ++batch) {
        std::vector<Pass> passes;
        for (int number = 0; number < passCount; ++number)
            passes.push_back(pass(light, batch, number, passCount));
        const int tiles = passes[0].tileCount() * passCount;
        const int done = tiles * (index * batches + batch);
        runBatch(scene, passes, tallies, done, tiles * batches * int(_job.scene.lights.size()));
        for (const auto& [i, map] : maps)
            map->closeBatch();
    }
    Tally sum;
    for (const Tally& tally : tallies)
        sum.add(tally);
    TracedLight traced{fixed.watts(sum.entering),
                       fixed.watts(sum.absorbed),
                       fixed.watts(sum.scattered),
                       0,
                       fixed.watts(sum.missed),
                       fixed.watts(sum.rejected),
                       sum.photons};
    for (const auto& [i, map] : maps) {
        finished[i] = map->finished();
        traced.deposited += finished[i].deposited;
    }
    return traced;
}

} // namespace

TraceResult traceLight(const TraceJob& job, const TraceOptions& options) {
    return Tracer(job, options).run();
}

} // namespace limpid::reference
