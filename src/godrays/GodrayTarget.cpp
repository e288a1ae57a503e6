#include "godrays/GodrayTarget.h"

#include "gl/Bindings.h"

namespace limpid {

GodrayTarget::GodrayTarget(gl::Context& context)
    : _context(context),
      _receivers({"godrays/view_depth.vert", "levelmap/face.geom", "godrays/view_depth.frag"}),
      _surface({"godrays/view_surface.vert", "godrays/view_surface.frag"}) {}

void GodrayTarget::resize(glm::ivec2 size) {
    if (_radiance.id() != 0 && _radiance.size() == size) return;
    gl::Ledger& ledger = _context.ledger();
    _radiance = {}; // it comes last: memory may run out
    _depth = gl::Texture(ledger, "depth buffer", GL_DEPTH_COMPONENT32F, size);
    _radiance = gl::Texture(ledger, "godrays", GL_RGBA32F, size);
    _radiance.setFilter(GL_LINEAR, GL_CLAMP_TO_EDGE);
    const gl::Texture* const targets[] = {&_radiance};
    _target = gl::Framebuffer("godrays", targets, &_depth);
    _flat = gl::Framebuffer("godrays", targets);
}

void GodrayTarget::begin(const GodrayInputs& inputs, Surface surface) {
    resize(godrayTargetSize(inputs.camera.size, inputs.scene.godrays.scale));
    _target.clearColor(glm::vec4(0));
    _target.clearDepth(0);
    _target.bind();
    const NearIsOneTested reversed;
    for (const ReceiverGeometry& receiver : inputs.receivers)
        receiver.draw(_receivers);
    gl::VertexArray grid;
    grid.attribute(positionAttribute, inputs.surface.positions, 4, 0, sizeof(glm::vec4));
    grid.indices(inputs.surface.indices);
    grid.bind();
    _surface.use();
    if (surface == Surface::Blended) glDepthMask(GL_FALSE);
    glDrawElements(GL_TRIANGLES, 3 * inputs.surface.triangleCount, GL_UNSIGNED_INT, nullptr);
    glDepthMask(GL_TRUE);
}

} // namespace limpid
