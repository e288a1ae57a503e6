#include "caustics/DrawnPlanes.h"

namespace limpid {

namespace {
enum Uniform { PlaneNumber = 1 };
} // namespace

DrawnPlanes::DrawnPlanes(gl::Context& context)
    : _context(context), _drawer(context, "caustics/drawn_plane.frag") {}

void DrawnPlanes::fill(CausticMap& caustics, const LevelMap& map, const Beams& beams,
                       const WaterMesh& surface, const Water& water) {
    caustics.resize(_context, map.frame.size);
    const gl::Texture* const targets[] = {&caustics.irradiance};
    const gl::Framebuffer framebuffer("caustic map", targets);
    framebuffer.clearColor(0, glm::vec4(0));
    if (beams.strength == glm::dvec3(0)) return;

    _drawer.prepare(map, beams, surface, water);
    framebuffer.bind();
    map.position.bind(0);
    map.diffuse.bind(1);
    map.normal.bind(2);
    for (const ReferencePlane& plane : map.planes) {
        _drawer.program().set(PlaneNumber, plane.index);
        _drawer.draw(plane);
    }
}

} // namespace limpid
