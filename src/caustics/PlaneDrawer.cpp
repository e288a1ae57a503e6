#include "caustics/PlaneDrawer.h"

#include "gl/Bindings.h"
#include "gl/Blending.h"

namespace limpid {

PlaneDrawer::PlaneDrawer(gl::Context& context, const char* fragmentShader)
    : _footprints(context), _program({"caustics/drawn_plane.vert", fragmentShader}) {}

void PlaneDrawer::prepare(const LevelMap& map, const Beams& beams, const WaterMesh& surface,
                          const Water& water) {
    _footprints.update(beams, surface, map);
    beams.frame.bindUniform(lightFrameBlock);
    map.box.bindUniform(boxFrameBlock);
    if (beams.surfaceShadow) beams.surfaceShadow->bind(surfaceShadowUnit);
    _program.set(testSurfaceShadowLocation, beams.surfaceShadow ? 1 : 0);
    _program.set(strengthLocation, glm::vec3(beams.strength));
    _program.set(extinctionPerMetreLocation, glm::vec3(water.absorption + water.scattering));
}

void PlaneDrawer::draw(const ReferencePlane& plane) const {
    _footprints.areas().bindStorage(beamAreasBuffer);
    _footprints.vertexArray().bind();
    _program.use();
    _program.set(planeDepthLocation, float(plane.depth));
    const gl::Adding adding;
    glDrawElements(GL_TRIANGLES, 3 * _footprints.triangleCount(), GL_UNSIGNED_INT, nullptr);
}

} // namespace limpid
