#include "caustics/DrawnPlanes.h"

#include "gl/Bindings.h"

namespace limpid {

DrawnPlanes::DrawnPlanes(gl::Context& context)
    : _context(context), _drawer(context, "caustics/drawn_plane.frag") {}

void DrawnPlanes::fill(CausticMap& caustics, const LevelMap& map, const Beams& beams,
                       const WaterMesh& surface, const Water& water) {
    caustics.resize(_context, map.frame.size);
    const gl::Texture* const targets[] = {&caustics.irradiance};
    const gl::Framebuffer framebuffer("caustic map", targets);
    framebuffer.clearColor(glm::vec4(0));
    if (beams.strength == glm::dvec3(0)) return;

    _drawer.prepare(map, beams, surface, water);
    framebuffer.bind();
    map.position.bind(positionMapUnit);
    map.diffuse.bind(diffuseMapUnit);
    map.normal.bind(normalMapUnit);
    for (const ReferencePlane& plane : map.planes) {
        _drawer.program().set(planeNumberLocation, plane.index);
        _drawer.draw(plane);
    }
}

} // namespace limpid
