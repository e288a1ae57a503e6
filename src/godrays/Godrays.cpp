#include "godrays/Godrays.h"

#include <algorithm>

#include "core/ShaderData.h"
#include "gl/Bindings.h"

namespace limpid {

glm::ivec2 godrayTargetSize(glm::ivec2 size, double scale) {
    return glm::max(glm::ivec2(glm::round(glm::dvec2(size) * scale)), 1);
}

gl::Buffer godrayFrame(gl::Ledger& ledger, const GodrayInputs& inputs, const GodraySource& source) {
    const GodraySettings& settings = inputs.scene.godrays;
    const Water& water = inputs.scene.water;
    const glm::dvec2 target(godrayTargetSize(inputs.camera.size, settings.scale));
    const glm::mat4& view = inputs.camera.viewProjection;
    // The projection's scales are the lengths of its rows: what turns the view is orthonormal.
    const glm::dvec2 focus(glm::length(glm::dvec3(view[0][0], view[1][0], view[2][0])),
                           glm::length(glm::dvec3(view[0][1], view[1][1], view[2][1])));
    gpu::GodrayFrame data;
    data.viewProjection = view;
    data.cameraPosition = glm::vec4(inputs.camera.position, view[3][2] * 1.001f);
    data.target = glm::vec4(target, 0.5 * target * focus);
    data.strength = glm::vec4(source.beams.strength, settings.phase == Phase::Schlick ? 1 : 0);
    data.scattering = glm::vec4(water.scattering, water.anisotropy);
    data.extinctionPerMetre = glm::vec4(water.absorption + water.scattering, 0);
    return {ledger, "view", sizeof(data), &data};
}

void bindPhotons(const gl::Program& program, const GodrayInputs& inputs, const GodraySource& source) {
    source.beams.frame.bindUniform(lightFrameBlock);
    source.sceneDepth.bind();
    if (source.beams.surfaceShadow) source.beams.surfaceShadow->bind(surfaceShadowUnit);
    inputs.surface.indices.bindStorage(indicesBuffer);
    source.beams.origins.bindStorage(beamOriginsBuffer);
    source.beams.directions.bindStorage(beamDirectionsBuffer);
    source.beams.flux.bindStorage(beamFluxBuffer);
    const GodraySettings& settings = inputs.scene.godrays;
    const glm::vec4 rect = rectOf(inputs.patch, inputs.origin);
    program.set(patchRectLocation, rect);
    program.set(quadsLocation, inputs.surface.quads);
    program.set(photonRectLocation, rect);
    program.set(cellsLocation, settings.grid);
    program.set(subdivisionLocation, settings.subdivision);
}

double godrayReach(const GodrayInputs& inputs, const GodraySource& source, double mostExtinction) {
    const glm::dvec3 lost = inputs.scene.water.absorption + inputs.scene.water.scattering;
    const double least = std::min({lost.x, lost.y, lost.z});
    const double far = 20 * (source.farthest + glm::length(inputs.patch.size));
    return least > 0 ? std::min(far, mostExtinction / least) : far;
}

} // namespace limpid
