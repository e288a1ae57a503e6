#include "caustics/PhotonSplat.h"

#include <algorithm>

#include "caustics/FluxSums.h"
#include "water/FlatWater.h"

namespace limpid {

namespace {

enum CastUniform {
    PatchRect,
    Quads,
    PhotonRect,
    Cells,
    Subdivision,
    StepsPerFlux,
    ExtinctionPerMetre,
    CastChannels,
    Splat,
    TestSurfaceShadow,
    TestOcclusion,
    ReceiverNumber
};
enum FilterUniform { FilterChannels, Taps, Radius };
enum ResolveUniform { WattsPerStep, Channels, Filtered };
constexpr int groupSize = 64;
constexpr glm::ivec2 mapGroupSize{8, 8};
constexpr double mostSplat = 256; ///< texels

/// The part of the photon grid whose photons may come to the receiver; a quad of the patch is a cell.
WaterPatch photonGrid(const PhotonSplat::Inputs& inputs) {
    const CausticsSettings& settings = inputs.scene.caustics;
    const glm::ivec2 cells = settings.photonGrid;
    WaterPatch part = lightingPatch(inputs.scene.water, inputs.light, inputs.wet, inputs.patch);
    part.grid = cells;
    if (settings.photonGridOver == PhotonGridOver::Receiver) return part;
    const glm::dvec2 cell = inputs.patch.size / glm::dvec2(cells);
    const glm::dvec2 low = (part.min() - inputs.patch.min()) / cell, high = low + part.size / cell;
    const glm::ivec2 first = glm::clamp(glm::ivec2(glm::floor(low)), glm::ivec2(0), cells - 1);
    const glm::ivec2 end = glm::clamp(glm::ivec2(glm::ceil(high)), first + 1, cells);
    return {inputs.patch.min() + 0.5 * glm::dvec2(first + end) * cell, glm::dvec2(end - first) * cell,
            end - first};
}

/// Light on its way from the level to the receiver's corner that has least or most of it.
struct WaterWay {
    double nearest = 1e300, farthest = 0; ///< m
    double spread = 1; ///< how much further apart a lamp's rays are there than at the level, at most
};

WaterWay waterWay(const PhotonSplat::Inputs& inputs) {
    WaterWay way;
    for (int i = 0; i < 8; ++i) {
        const glm::dvec3 corner = inputs.wet.corner(i);
        const glm::dvec3 entry = entryPoint(inputs.light, inputs.scene.water, corner);
        const double metres = glm::distance(corner, entry);
        way.nearest = std::min(way.nearest, metres);
        way.farthest = std::max(way.farthest, metres);
        if (inputs.light.type == LightType::Point)
            way.spread = std::max(way.spread, 1 + metres / glm::distance(entry, inputs.light.position));
    }
    return way;
}

/// Of splats, texels. One grid over all water is coarse beside a small receiver's map: its splats are twice
/// as wide as photons are apart, so that light which spreads to half leaves no gaps.
glm::dvec2 sizesOf(const PhotonSplat::Inputs& inputs, const WaterPatch& photons, const WaterWay& way) {
    const CausticsSettings& settings = inputs.scene.caustics;
    if (settings.photonGridOver == PhotonGridOver::Receiver) return settings.splatSize;
    const glm::dvec2 apart = photons.size / glm::dvec2(photons.grid * settings.photonSubdivision);
    const double gapless = 2 * way.spread * std::max(apart.x, apart.y) / inputs.map.frame.texel;
    return glm::max(settings.splatSize, glm::dvec2(std::min(gapless, mostSplat)));
}

/// A photon is shared among the texels of its splat.
double fluxPerStepOf(const PhotonSplat::Inputs& inputs, const WaterPatch& photons, const glm::dvec2& sizes) {
    const CausticsSettings& settings = inputs.scene.caustics;
    const double side = settings.photonSubdivision * sizes.y;
    const double parts = double(photons.grid.x) * photons.grid.y * side * side;
    return fluxPerStep(inputs.map, inputs.light, photons, parts);
}

} // namespace

glm::dvec2 splatSizes(const glm::dvec2& sizes, double nearest, double farthest) {
    // What touches the water has no nearest distance to speak of.
    nearest = std::max(nearest, 0.01 * farthest);
    const double across = 1 / nearest - 1 / farthest;
    if (!(across * farthest > 1e-3)) return {sizes.x, 0};
    const double b = (sizes.y - sizes.x) / across;
    return {sizes.x - b / farthest, b};
}

PhotonSplat::PhotonSplat(gl::Context& context)
    : _context(context), _cast({"caustics/photon_splat.comp"}), _filter({"caustics/photon_filter.comp"}),
      _resolve({"caustics/photon_resolve.comp"}) {}

/// The two behind the texels' are what photon_filter.comp counts.
void PhotonSplat::reserveSums(std::int64_t count, bool filtered) {
    for (gl::Buffer* sums : {&_splats, &_sums}) {
        if (sums->bytes() >= 8 * count || (sums == &_splats && !filtered)) continue;
        *sums = gl::Buffer(_context.ledger(), "flux sums", 8 * count);
        sums->clearToZero();
    }
}

void PhotonSplat::cast(const Inputs& inputs, const WaterPatch& photons, const glm::vec4& splat, int channels,
                       double stepsPerFlux) {
    const CausticsSettings& settings = inputs.scene.caustics;
    const Water& water = inputs.scene.water;
    inputs.beams.frame.bindUniform(0);
    if (inputs.sceneDepth) inputs.sceneDepth->bind();
    if (inputs.beams.surfaceShadow) inputs.beams.surfaceShadow->bind(surfaceShadowUnit);
    inputs.surface.indices.bindStorage(0);
    inputs.beams.origins.bindStorage(3);
    inputs.beams.directions.bindStorage(4);
    inputs.beams.flux.bindStorage(5);
    _cast.set(PatchRect, rectOf(inputs.patch, inputs.origin));
    _cast.set(Quads, inputs.surface.quads);
    _cast.set(PhotonRect, rectOf(photons, inputs.origin));
    _cast.set(Cells, photons.grid);
    _cast.set(Subdivision, settings.photonSubdivision);
    _cast.set(StepsPerFlux, float(stepsPerFlux));
    _cast.set(ExtinctionPerMetre, glm::vec3(water.absorption + water.scattering));
    _cast.set(CastChannels, channels);
    _cast.set(Splat, splat);
    _cast.set(TestSurfaceShadow, inputs.beams.surfaceShadow ? 1 : 0);
    _cast.set(TestOcclusion, inputs.sceneDepth ? 1 : 0);
    _cast.set(ReceiverNumber, inputs.receiver);
    _cast.dispatch(std::int64_t(photons.grid.x) * photons.grid.y, groupSize);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

void PhotonSplat::filter(const Inputs& inputs, int channels) {
    _splats.bindStorage(9);
    _sums.bindStorage(8);
    _filter.set(FilterChannels, channels);
    _filter.set(Taps, inputs.scene.caustics.filterTaps);
    _filter.set(Radius, float(inputs.scene.caustics.filterRadius));
    _filter.dispatch2D(inputs.map.frame.size, mapGroupSize);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

void PhotonSplat::fill(CausticMap& caustics, const Inputs& inputs) {
    caustics.resize(_context, inputs.map.frame.size);
    const glm::ivec2 size = inputs.map.frame.size;
    const int channels = channelsOf(Colours::AsNeeded, inputs.scene.water);
    const bool filtered = inputs.scene.caustics.filterTaps > 0;
    reserveSums((std::int64_t(size.x) * size.y + 2) * channels, filtered);
    const WaterPatch photons = photonGrid(inputs);
    const WaterWay way = waterWay(inputs);
    const glm::dvec2 sizes = sizesOf(inputs, photons, way);
    const glm::vec4 splat(glm::vec2(splatSizes(sizes, way.nearest, way.farthest)), glm::vec2(sizes));
    const double perStep = fluxPerStepOf(inputs, photons, sizes);
    inputs.map.box.bindUniform(1);
    inputs.planes.planes.bind(0);
    inputs.map.normal.bind(2);
    (filtered ? _splats : _sums).bindStorage(8);
    if (inputs.beams.strength != glm::dvec3(0)) {
        cast(inputs, photons, splat, channels, 1 / perStep);
        if (filtered) filter(inputs, channels);
    }
    inputs.map.normal.bind(0);
    caustics.irradiance.bindImage(0, GL_WRITE_ONLY);
    _sums.bindStorage(8);
    _resolve.set(WattsPerStep, glm::vec3(inputs.beams.strength * (perStep / inputs.map.frame.texelArea())));
    _resolve.set(Channels, channels);
    _resolve.set(Filtered, filtered ? 1 : 0);
    _resolve.dispatch2D(size, mapGroupSize);
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
    if (!filtered) return;
    _splats.clearToZero();
    _sums.clearToZero();
}

} // namespace limpid
