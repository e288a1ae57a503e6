#include "caustics/PhotonSplat.h"

#include <algorithm>
#include <string>
#include <vector>

#include "caustics/FluxSums.h"
#include "core/ShaderData.h"
#include "gl/Bindings.h"
#include "plan/FlatWater.h"

namespace limpid {

namespace {

constexpr int groupSize = 64;
constexpr glm::ivec2 mapGroupSize{8, 8};
constexpr double mostSplat = 256; ///< texels
/// Photons of a dispatch: a work group of the second pass each, in one row.
constexpr std::int64_t mostAtOnce = 65535;

constexpr gpu::PhotonsLeft noneLeft{{0, 1, 1}, 0};

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
    double spread = 1; ///< how much further apart a point light's rays are there than at the level, at most
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

/// Word of the splats' sums where marks of shade begin.
int shadeMarks(const PhotonSplat::Inputs& inputs, int channels) {
    const glm::ivec2 size = inputs.map.frame.size;
    return 2 * (size.x * size.y + 2) * channels;
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
    : _context(context), _filter({"caustics/photon_filter.comp"}),
      _resolve({"caustics/photon_resolve.comp"}) {}

/// Compiled when first needed.
const gl::Program& PhotonSplat::castProgram(Pass pass, bool veiled) {
    std::optional<gl::Program>& program = _cast[pass == Pass::All ? 0 : veiled ? 2 : 1];
    if (program) return *program;
    std::vector<std::string> defines;
    if (pass == Pass::Left) defines.emplace_back("SHADED");
    if (pass == Pass::Left && veiled) defines.emplace_back("VEILS");
    return program.emplace(std::initializer_list<const char*>{"caustics/photon_splat.comp"}, defines);
}

/// Room for sums of so many texels. The two behind the texels' are what photon_filter.comp counts; behind
/// these, splats have a mark for each texel.
void PhotonSplat::reserveSums(std::int64_t texels, int channels, bool filtered) {
    for (gl::Buffer* sums : {&_splats, &_sums}) {
        const std::int64_t bytes = 8 * (texels + 2) * channels + (sums == &_splats ? 4 * texels : 0);
        if (sums->bytes() >= bytes || (sums == &_splats && !filtered)) continue;
        *sums = gl::Buffer(_context.ledger(), "flux sums", bytes);
        sums->clearToZero();
    }
}

void PhotonSplat::bind(const Inputs& inputs) const {
    inputs.beams.frame.bindUniform(lightFrameBlock);
    if (inputs.occluders) inputs.occluders->bind();
    if (inputs.beams.surfaceShadow) inputs.beams.surfaceShadow->bind(surfaceShadowUnit);
    inputs.surface.indices.bindStorage(indicesBuffer);
    inputs.beams.origins.bindStorage(beamOriginsBuffer);
    inputs.beams.directions.bindStorage(beamDirectionsBuffer);
    inputs.beams.flux.bindStorage(beamFluxBuffer);
    _left.bindStorage(photonsLeftBuffer);
}

/// Photons in bands, so that the list of those left has room for all of a band.
void PhotonSplat::cast(const Inputs& inputs, const Cast& settings) {
    const int each = inputs.scene.caustics.photonSubdivision * inputs.scene.caustics.photonSubdivision;
    const std::int64_t photons = std::int64_t(settings.photons.grid.x) * settings.photons.grid.y * each;
    const std::int64_t band = std::min(photons, mostAtOnce);
    const std::int64_t bytes = std::int64_t(sizeof(noneLeft)) + std::int64_t(sizeof(gpu::LeftPhoton)) * band;
    if (_left.bytes() < bytes) _left = gl::Buffer(_context.ledger(), "photons", bytes);
    bind(inputs);
    const gl::Program& all = castProgram(Pass::All, false);
    const gl::Program& left = castProgram(Pass::Left, inputs.occluders && inputs.occluders->veiled());
    set(all, inputs, settings);
    set(left, inputs, settings);
    left.set(shadeMarksLocation,
             inputs.scene.caustics.filterTaps > 0 ? shadeMarks(inputs, settings.channels) : 0);
    for (std::int64_t first = 0; first < photons; first += band) {
        _left.write(0, sizeof(noneLeft), &noneLeft);
        all.set(firstPhotonLocation, int(first));
        all.set(endPhotonLocation, int(std::min(first + band, photons)));
        all.dispatch(std::min(band, photons - first), groupSize);
        glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);
        left.dispatchIndirect(_left, 0);
        glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
    }
}

void PhotonSplat::set(const gl::Program& cast, const Inputs& inputs, const Cast& settings) const {
    const CausticsSettings& caustics = inputs.scene.caustics;
    const Water& water = inputs.scene.water;
    cast.set(patchRectLocation, rectOf(inputs.patch, inputs.origin));
    cast.set(quadsLocation, inputs.surface.quads);
    cast.set(photonRectLocation, rectOf(settings.photons, inputs.origin));
    cast.set(cellsLocation, settings.photons.grid);
    cast.set(subdivisionLocation, caustics.photonSubdivision);
    cast.set(stepsPerFluxLocation, float(settings.stepsPerFlux));
    cast.set(extinctionPerMetreLocation, glm::vec3(water.absorption + water.scattering));
    cast.set(channelsLocation, settings.channels);
    cast.set(splatSizesLocation, settings.splat);
    cast.set(testSurfaceShadowLocation, inputs.beams.surfaceShadow ? 1 : 0);
    cast.set(receiverNumberLocation, inputs.receiver);
    cast.set(testOcclusionLocation, inputs.occluders ? 1 : 0);
}

void PhotonSplat::filter(const Inputs& inputs, int channels) {
    _splats.bindStorage(splatSumsBuffer);
    _sums.bindStorage(fluxSumsBuffer);
    _filter.set(channelsLocation, channels);
    _filter.set(tapsLocation, inputs.scene.caustics.filterTaps);
    _filter.set(radiusLocation, float(inputs.scene.caustics.filterRadius));
    _filter.set(shadeMarksLocation, shadeMarks(inputs, channels));
    _filter.dispatch2D(inputs.map.frame.size, mapGroupSize);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

void PhotonSplat::fill(CausticMap& caustics, const Inputs& inputs) {
    caustics.resize(_context, inputs.map.frame.size);
    const glm::ivec2 size = inputs.map.frame.size;
    const bool coloured = inputs.occluders && inputs.occluders->coloured();
    const int channels = channelsOf(inputs.colours, inputs.scene.water, coloured);
    const bool filtered = inputs.scene.caustics.filterTaps > 0;
    reserveSums(std::int64_t(size.x) * size.y, channels, filtered);
    const WaterPatch photons = photonGrid(inputs);
    const WaterWay way = waterWay(inputs);
    const glm::dvec2 sizes = sizesOf(inputs, photons, way);
    const glm::vec4 splat(glm::vec2(splatSizes(sizes, way.nearest, way.farthest)), glm::vec2(sizes));
    const double perStep = fluxPerStepOf(inputs, photons, sizes);
    inputs.map.box.bindUniform(boxFrameBlock);
    inputs.planes.planes.bind(tangentPlanesUnit);
    inputs.map.normal.bind(normalMapUnit);
    (filtered ? _splats : _sums).bindStorage(fluxSumsBuffer);
    if (inputs.beams.strength != glm::dvec3(0)) {
        cast(inputs, {photons, splat, channels, 1 / perStep});
        if (filtered) filter(inputs, channels);
    }
    inputs.map.normal.bind(normalMapUnit);
    caustics.irradiance.bindImage(irradianceImage, GL_WRITE_ONLY);
    _sums.bindStorage(fluxSumsBuffer);
    _resolve.set(wattsPerStepLocation,
                 glm::vec3(inputs.beams.strength * (perStep / inputs.map.frame.texelArea())));
    _resolve.set(channelsLocation, channels);
    _resolve.set(filteredLocation, filtered ? 1 : 0);
    _resolve.dispatch2D(size, mapGroupSize);
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
    if (!filtered) return;
    _splats.clearToZero();
    _sums.clearToZero();
}

} // namespace limpid
