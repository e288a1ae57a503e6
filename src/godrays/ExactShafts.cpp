#include "godrays/ExactShafts.h"

#include <algorithm>
#include <cmath>

#include "gl/Bindings.h"

namespace limpid {

namespace {

constexpr int groupSize = 64;

/// Of light that meets nothing, what is followed: e^-9 of it, one in eight thousand, is left in the clearest
/// channel.
constexpr double mostExtinction = 9;
/// Of one gap below the receivers to the next.
constexpr double growth = 1.25;
/// How far aside of the mean light a beam may go, by metre of depth, and still be in the layers: what a wave
/// of slope 0.8 bends light by.
constexpr double stray = 0.2;
/// Steps of the integer sums for light that nothing focuses: what one of twenty rays of a cell adds to its
/// corner by a phase function of 0.002 sr⁻¹ is then still a hundred of them.
constexpr double stepsOfEven = 0x1p24;

/// The slope that light from a point light spreads by at most: at grazing incidence.
double widest(const Water& water) {
    return 1 / std::sqrt(std::max(water.ior * water.ior - 1, 1e-6));
}

/// Metres below which a point light's light seems to come from, over the level, seen from straight below it.
double fanHeight(const GodrayInputs& inputs, const GodraySource& source) {
    return std::max(source.light.position.y - inputs.scene.water.level, 1e-6) * inputs.scene.water.ior;
}

/// Flux of 1 m² of the level, in the unit of beams, about where a point light is closest.
double evenFlux(const GodrayInputs& inputs, const GodraySource& source) {
    if (source.light.type == LightType::Directional) return 1;
    const double height = std::max(source.light.position.y - inputs.scene.water.level, 1e-6);
    const double far = std::max(height, 0.25 * glm::length(inputs.patch.size));
    return 1 / (far * far);
}

glm::vec4 layerRect(const GodrayInputs& inputs, const GodraySource& source, double depth, double margin) {
    const WaterPatch& patch = inputs.patch;
    const Water& water = inputs.scene.water;
    const glm::dvec2 origin(inputs.origin.x, inputs.origin.z);
    glm::dvec2 min = patch.min(), max = min + patch.size;
    if (source.light.type == LightType::Directional) {
        const glm::dvec3 light = refractedAt(source.light, water, {});
        const glm::dvec2 aside = glm::dvec2(light.x, light.z) / -light.y * depth;
        min += aside, max += aside;
    } else {
        const glm::dvec2 pointLight(source.light.position.x, source.light.position.z);
        const double height = fanHeight(inputs, source), most = widest(water);
        min += glm::clamp((min - pointLight) / height, -most, most) * depth;
        max += glm::clamp((max - pointLight) / height, -most, most) * depth;
    }
    return glm::vec4(min - margin - origin, max - min + 2 * margin);
}

} // namespace

ExactShafts::Gaps shaftGaps(const GodrayInputs& inputs, const GodraySource& source,
                            std::int64_t storageBytes) {
    const GodraySettings& settings = inputs.scene.godrays;
    ExactShafts::Gaps gaps;
    gaps.even = settings.planes;
    double depth = 0;
    // Receivers are at most so deep: their distance along the light is no shorter.
    const double reach = godrayReach(inputs, source, mostExtinction);
    const double deepest = std::min(source.farthest, reach);
    gaps.height = deepest / settings.planes;
    double height = gaps.height;
    while (int(gaps.gaps.size()) < gaps.even || depth < reach) {
        if (int(gaps.gaps.size()) >= gaps.even) height *= growth;
        const double middle = depth + 0.5 * height;
        gaps.gaps.push_back({layerRect(inputs, source, middle, stray * std::max(middle, deepest)),
                             glm::vec4(depth, middle, depth + height, 0)});
        depth += height;
    }
    // A cell for each ray, which makes light even that nothing focuses; larger ones where the sums, of eight
    // bytes, would not fit.
    const glm::dvec2 spread(gaps.gaps[0].rect.z, gaps.gaps[0].rect.w);
    const glm::dvec2 cells = glm::dvec2(settings.grid * settings.subdivision) * spread / inputs.patch.size;
    const double most = double(storageBytes) / 8 / double(gaps.gaps.size());
    gaps.cells =
        glm::max(glm::ivec2(cells * std::min(1.0, std::sqrt(most / (cells.x * cells.y)))), glm::ivec2(1));
    return gaps;
}

ExactShafts::ExactShafts(gl::Context& context)
    : _context(context), _deposit({"godrays/shaft_deposit.comp"}), _resolve({"godrays/shaft_resolve.comp"}),
      _march({"gl/screen.vert", "godrays/shafts.frag"}) {}

void ExactShafts::light(const GodrayInputs& inputs, const GodraySource& source, const Gaps& gaps) {
    const GodraySettings& settings = inputs.scene.godrays;
    bindPhotons(_deposit, inputs, source);
    const double steps = stepsOfEven / evenFlux(inputs, source);
    _deposit.set(cellsAcrossLocation, gaps.cells);
    _deposit.set(gapCountLocation, int(gaps.gaps.size()));
    _deposit.set(stepsLocation, float(steps));
    _deposit.set(testSurfaceShadowLocation, source.beams.surfaceShadow ? 1 : 0);
    _deposit.dispatch(std::int64_t(settings.grid.x) * settings.grid.y * settings.subdivision *
                          settings.subdivision,
                      groupSize);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    resolve(gaps, steps);
}

void ExactShafts::resolve(const Gaps& gaps, double steps) {
    glBindImageTexture(litImage, _lit.id(), 0, GL_TRUE, 0, GL_WRITE_ONLY, GL_R32F);
    _resolve.set(cellsAcrossLocation, gaps.cells);
    _resolve.set(gapCountLocation, int(gaps.gaps.size()));
    _resolve.set(stepsLocation, float(steps));
    _resolve.dispatch(std::int64_t(gaps.cells.x) * gaps.cells.y * std::int64_t(gaps.gaps.size()), groupSize);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
}

void ExactShafts::march(const GodrayInputs& inputs, const GodraySource& source, const Gaps& gaps) {
    const Water& water = inputs.scene.water;
    const glm::dvec3 lost = water.absorption + water.scattering;
    _march.set(evenGapsLocation, gaps.even);
    _march.set(gapCountLocation, int(gaps.gaps.size()));
    _march.set(gapHeightLocation, float(gaps.height));
    _march.set(gapGrowthLocation, float(growth));
    _march.set(stepCountLocation, inputs.scene.godrays.steps);
    _march.set(nearLocation, inputs.camera.viewProjection[3][2]);
    _march.set(meanLostLocation, float((lost.x + lost.y + lost.z) / 3));
    const glm::dvec3 pointLight = source.light.position - inputs.origin;
    _march.set(fanLocation,
               glm::vec4(pointLight.x, pointLight.z, 1 / fanHeight(inputs, source), widest(water)));
    _lit.bind(litUnit);
    _noVertices.bind();
    _march.use();
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

void ExactShafts::draw(GodrayTarget& target, const GodrayInputs& inputs) {
    bool begun = false;
    for (const GodraySource& source : inputs.sources) {
        const Gaps gaps = shaftGaps(inputs, source, _context.info().maxStorageBlockBytes);
        const auto layers = int(gaps.gaps.size());
        const std::int64_t bytes = std::int64_t(gaps.cells.x) * gaps.cells.y * layers * 8;
        gl::Ledger& ledger = _context.ledger();
        if (_lit.id() == 0 || _lit.size() != gaps.cells || _lit.layers() != layers) {
            _sums = {}, _lit = {}; // free before more is asked for
            _sums = gl::Buffer(ledger, "lit water", bytes);
            _sums.clearToZero();
            _lit = gl::Texture(ledger, "lit water", GL_R32F, gaps.cells, gl::Layers{layers});
            _lit.setFilter(GL_LINEAR, GL_CLAMP_TO_EDGE);
        }
        _gaps = gl::Buffer(ledger, "lit water", std::span<const gpu::Gap>(gaps.gaps));
        _gaps.bindStorage(gapsBuffer);
        _sums.bindStorage(fluxSumsBuffer);
        const gl::Buffer frame = godrayFrame(ledger, inputs, source);
        frame.bindUniform(godrayFrameBlock);
        light(inputs, source, gaps);
        if (!begun) target.begin(inputs, GodrayTarget::Surface::Solid);
        begun = true;
        target.bindWithoutDepth();
        source.sceneDepth.bind();
        target.depth().bind(viewDepthUnit);
        const gl::Adding adding;
        march(inputs, source, gaps);
    }
}

} // namespace limpid
