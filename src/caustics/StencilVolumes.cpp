#include "caustics/StencilVolumes.h"

#include <cstdint>

#include "core/ShaderData.h"
#include "gl/Bindings.h"
#include "gl/Blending.h"

namespace limpid {

namespace {

constexpr int groupSize = 64;

/// Marks what lies before a back face; a front face takes its marks away, whether it draws there or not.
void testStencil() {
    glEnable(GL_STENCIL_TEST);
    glStencilFuncSeparate(GL_BACK, GL_ALWAYS, 1, 0xff);
    glStencilOpSeparate(GL_BACK, GL_KEEP, GL_REPLACE, GL_KEEP);
    glStencilFuncSeparate(GL_FRONT, GL_EQUAL, 1, 0xff);
    glStencilOpSeparate(GL_FRONT, GL_KEEP, GL_ZERO, GL_ZERO);
}

} // namespace

StencilVolumes::StencilVolumes(gl::Context& context)
    : _context(context), _footprints(context), _find({"caustics/stencil_ranges.comp"}),
      _objects({"gl/screen.vert", "caustics/stencil_objects.frag"}),
      _volumes(
          {"caustics/stencil_volume.vert", "caustics/stencil_volume.geom", "caustics/stencil_volume.frag"}),
      _light({"gl/screen.vert", "caustics/stencil_light.frag"}) {}

void StencilVolumes::findSubVolumes(const LevelMap& map, const Beams& beams, const WaterMesh& surface) {
    _footprints.update(beams, surface, map);
    const std::int64_t bytes = std::int64_t(beams.triangleCount) * 8;
    if (_ranges.bytes() != bytes) _ranges = gl::Buffer(_context.ledger(), "sub-volumes", bytes);
    if (!_draw.id()) _draw = gl::Buffer(_context.ledger(), "sub-volumes", sizeof(gpu::DrawCommand));
    const gpu::DrawCommand none{std::uint32_t(beams.triangleCount), 0, 0, 0};
    _draw.write(0, sizeof(none), &none);
    surface.indices.bindStorage(indicesBuffer);
    _footprints.rays().bindStorage(footprintsBuffer);
    _footprints.originDepths().bindStorage(originDepthsBuffer);
    _footprints.areas().bindStorage(beamAreasBuffer);
    _ranges.bindStorage(rangesBuffer);
    _draw.bindStorage(drawCommandBuffer);
    _find.set(beamCountLocation, beams.triangleCount);
    _find.dispatch(beams.triangleCount, groupSize);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
}

/// Step 1: their depths alone.
void StencilVolumes::drawObjects(const LevelMap& map) const {
    map.position.bind(positionMapUnit);
    glDepthFunc(GL_ALWAYS);
    glColorMaski(0, GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    _objects.use();
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glColorMaski(0, GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthFunc(GL_LESS);
}

/// Steps 2 and 3, volume by volume: within a draw, faces are tested in the order they come in.
void StencilVolumes::drawSubVolumes(const Beams& beams, const Water& water) const {
    if (beams.surfaceShadow) beams.surfaceShadow->bind(surfaceShadowUnit);
    _volumes.set(testSurfaceShadowLocation, beams.surfaceShadow ? 1 : 0);
    _volumes.set(strengthLocation, glm::vec3(beams.strength));
    _volumes.set(extinctionPerMetreLocation, glm::vec3(water.absorption + water.scattering));
    testStencil();
    glDepthMask(GL_FALSE);
    const gl::Adding adding;
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, _draw.id());
    _volumes.use();
    glDrawArraysIndirect(GL_POINTS, nullptr);
    glDepthMask(GL_TRUE);
    glDisable(GL_STENCIL_TEST);
}

void StencilVolumes::multiply(const LevelMap& map) const {
    map.diffuse.bind(diffuseMapUnit);
    map.normal.bind(normalMapUnit);
    const gl::Multiplying multiplying;
    _light.use();
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

void StencilVolumes::fill(CausticMap& caustics, const LevelMap& map, const PlaneDepths& depths,
                          const Beams& beams, const WaterMesh& surface, const Water& water) {
    caustics.resize(_context, map.frame.size);
    const gl::Texture depth(_context.ledger(), "depth buffer", GL_DEPTH32F_STENCIL8, map.frame.size);
    const gl::Texture* const targets[] = {&caustics.irradiance};
    const gl::Framebuffer framebuffer("caustic map", targets, &depth);
    framebuffer.clearColor(glm::vec4(0));
    if (beams.strength == glm::dvec3(0)) return;
    map.box.bindUniform(boxFrameBlock);
    beams.frame.bindUniform(lightFrameBlock);
    depths.pyramid.bind(depthPyramidUnit);
    findSubVolumes(map, beams, surface);
    framebuffer.clearDepthStencil(0, 0);
    framebuffer.bind();
    _noVertices.bind();
    glEnable(GL_DEPTH_TEST);
    drawObjects(map);
    drawSubVolumes(beams, water);
    glDisable(GL_DEPTH_TEST);
    multiply(map);
}

} // namespace limpid
