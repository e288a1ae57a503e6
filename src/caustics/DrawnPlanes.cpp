#include "caustics/DrawnPlanes.h"

namespace limpid {

namespace {
enum Uniform { PlaneDepth, PlaneNumber, Strength, ExtinctionPerMetre, TestSurfaceShadow };
} // namespace

DrawnPlanes::DrawnPlanes(gl::Context& context)
    : _context(context), _footprints(context),
      _program({"caustics/drawn_plane.vert", "caustics/drawn_plane.frag"}) {}

void DrawnPlanes::fill(CausticMap& caustics, const LevelMap& map, const Beams& beams,
                       const WaterMesh& surface, const Water& water) {
    caustics.resize(_context, map.frame.size);
    const gl::Texture* const targets[] = {&caustics.irradiance};
    const gl::Framebuffer framebuffer("caustic map", targets);
    framebuffer.clearColor(0, glm::vec4(0));
    if (beams.strength == glm::dvec3(0)) return;

    _footprints.update(beams, surface, map);
    framebuffer.bind();
    map.box.bindUniform(1);
    map.position.bind(0);
    map.diffuse.bind(1);
    map.normal.bind(2);
    beams.frame.bindUniform(0);
    if (beams.surfaceShadow) beams.surfaceShadow->bind(surfaceShadowUnit);
    _program.set(TestSurfaceShadow, beams.surfaceShadow ? 1 : 0);
    _footprints.areas().bindStorage(8);
    _footprints.vertexArray().bind();
    _program.use();
    _program.set(Strength, glm::vec3(beams.strength));
    _program.set(ExtinctionPerMetre, glm::vec3(water.absorption + water.scattering));
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    for (const ReferencePlane& plane : map.planes) {
        _program.set(PlaneDepth, float(plane.depth));
        _program.set(PlaneNumber, plane.index);
        glDrawElements(GL_TRIANGLES, 3 * beams.triangleCount, GL_UNSIGNED_INT, nullptr);
    }
    glDisable(GL_BLEND);
}

} // namespace limpid
