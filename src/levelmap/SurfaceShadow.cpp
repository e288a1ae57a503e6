#include "levelmap/SurfaceShadow.h"

#include <algorithm>

#include "gl/Bindings.h"
#include "gl/Blending.h"

namespace limpid {

namespace {

constexpr glm::ivec2 mapSize{2048, 2048};

} // namespace

void SurfaceShadowPass::draw(gl::Texture& map, const Beams& beams,
                             std::span<const ReceiverGeometry> receivers) {
    if (!_program)
        _program.emplace(std::initializer_list<const char*>{
            "levelmap/surface_shadow.vert", "levelmap/face.geom", "levelmap/surface_shadow.frag"});
    if (!map.id()) map = gl::Texture(_context.ledger(), "surface shadow map", GL_R32F, mapSize);
    const gl::Texture* const targets[] = {&map};
    const gl::Framebuffer framebuffer("surface shadow map", targets);
    framebuffer.bind();
    framebuffer.clearColor(glm::vec4(0));
    beams.frame.bindUniform(lightFrameBlock);
    const gl::Blending greatest(GL_ONE, GL_ONE, GL_MAX);
    for (const ReceiverGeometry& receiver : receivers)
        receiver.draw(*_program);
}

} // namespace limpid
