#include "caustics/PlaneDrawer.h"

#include "gl/Blending.h"

namespace limpid {

namespace {
enum Uniform { PlaneDepth, Strength = 2, ExtinctionPerMetre, TestSurfaceShadow };
} // namespace

PlaneDrawer::PlaneDrawer(gl::Context& context, const char* fragmentShader)
    : _footprints(context), _program({"caustics/drawn_plane.vert", fragmentShader}) {}

void PlaneDrawer::prepare(const LevelMap& map, const Beams& beams, const WaterMesh& surface,
                          const Water& water) {
    _footprints.update(beams, surface, map);
    beams.frame.bindUniform(0);
    map.box.bindUniform(1);
    if (beams.surfaceShadow) beams.surfaceShadow->bind(surfaceShadowUnit);
    _program.set(TestSurfaceShadow, beams.surfaceShadow ? 1 : 0);
    _program.set(Strength, glm::vec3(beams.strength));
    _program.set(ExtinctionPerMetre, glm::vec3(water.absorption + water.scattering));
}

void PlaneDrawer::draw(const ReferencePlane& plane) const {
    _footprints.areas().bindStorage(8);
    _footprints.vertexArray().bind();
    _program.use();
    _program.set(PlaneDepth, float(plane.depth));
    const gl::Adding adding;
    glDrawElements(GL_TRIANGLES, 3 * _footprints.triangleCount(), GL_UNSIGNED_INT, nullptr);
}

} // namespace limpid
