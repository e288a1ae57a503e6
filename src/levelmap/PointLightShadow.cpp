#include "levelmap/PointLightShadow.h"

#include "gl/Bindings.h"
#include "gl/Blending.h"

namespace limpid {

namespace {
constexpr int side = 1024; // texels of each view: 0.1°
} // namespace

PointLightShadowPass::PointLightShadowPass(gl::Context& context)
    : _context(context), _program({"levelmap/point_light_shadow.vert", "levelmap/face.geom",
                                   "levelmap/point_light_shadow.frag"}) {}

void PointLightShadowPass::draw(gl::Texture& map, const Beams& beams,
                                std::span<const ReceiverGeometry> receivers) {
    if (!map.id())
        map = gl::Texture(_context.ledger(), "lamp shadow map", GL_R32F, {3 * side, 2 * side});
    const gl::Texture* const targets[] = {&map};
    const gl::Framebuffer framebuffer("lamp shadow map", targets);
    framebuffer.bind();
    framebuffer.clearColor(glm::vec4(1e30f));
    beams.frame.bindUniform(lightFrameBlock);
    const gl::Blending least(GL_ONE, GL_ONE, GL_MIN);
    for (int face = 0; face < 6; ++face) {
        framebuffer.bind({side * (face % 3), side * (face / 3)}, {side, side});
        _program.set(faceLocation, face);
        for (const ReceiverGeometry& receiver : receivers)
            receiver.draw(_program);
    }
}

} // namespace limpid
