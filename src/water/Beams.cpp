#include "water/Beams.h"

#include <cassert>
#include <cmath>

#include "gl/Bindings.h"
#include "plan/FlatWater.h"

namespace limpid {

namespace {
constexpr int groupSize = 64;
} // namespace

glm::dvec3 strengthOf(const Light& light, const Water& water) {
    if (!entersWater(light, water)) return glm::dvec3(0);
    return light.type == LightType::Directional ? light.irradiance : light.intensity;
}

BeamTracer::BeamTracer(gl::Context& context)
    : _context(context), _rays({"water/beams.comp"}), _flux({"water/beam_flux.comp"}) {}

void BeamTracer::prepare(Beams& beams, const WaterMesh& surface, const Light& light, const Water& water,
                         const LightFrameData& frame) {
    gl::Ledger& ledger = _context.ledger();
    if (beams.vertexCount != surface.vertexCount || beams.triangleCount != surface.triangleCount) {
        const auto bytes = std::int64_t(surface.vertexCount) * std::int64_t(sizeof(glm::vec4));
        beams.origins = gl::Buffer(ledger, "beams", bytes);
        beams.directions = gl::Buffer(ledger, "beams", bytes);
        beams.flux =
            gl::Buffer(ledger, "beams", std::int64_t(surface.triangleCount) * std::int64_t(sizeof(float)));
        beams.lit =
            gl::Buffer(ledger, "beams", std::int64_t(surface.triangleCount) * std::int64_t(sizeof(float)));
        beams.vertexCount = surface.vertexCount;
        beams.triangleCount = surface.triangleCount;
    }
    beams.frame = gl::Buffer(ledger, "beams", sizeof(LightFrameData), &frame);
    beams.rect = frame.sceneDepthRect;
    beams.strength = strengthOf(light, water);
}

void BeamTracer::trace(Beams& beams, const WaterMesh& surface, const gl::Texture* surfaceShadow) {
    assert(beams.vertexCount == surface.vertexCount && beams.triangleCount == surface.triangleCount);
    beams.frame.bindUniform(lightFrameBlock);
    surface.indices.bindStorage(indicesBuffer);
    surface.positions.bindStorage(positionsBuffer);
    surface.normals.bindStorage(normalsBuffer);
    beams.origins.bindStorage(beamOriginsBuffer);
    beams.directions.bindStorage(beamDirectionsBuffer);
    beams.flux.bindStorage(beamFluxBuffer);
    beams.lit.bindStorage(beamLitBuffer);
    beams.surfaceShadow = surfaceShadow;
    if (surfaceShadow) surfaceShadow->bind(surfaceShadowUnit);
    _rays.set(vertexCountLocation, beams.vertexCount);
    _rays.dispatch(beams.vertexCount, groupSize);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    _flux.set(triangleCountLocation, beams.triangleCount);
    _flux.dispatch(beams.triangleCount, groupSize);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

} // namespace limpid
