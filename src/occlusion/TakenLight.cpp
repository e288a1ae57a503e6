#include "occlusion/TakenLight.h"

#include <array>

#include "gl/Bindings.h"

namespace limpid {

namespace {
constexpr glm::ivec2 groupSize{8, 8};
} // namespace

TakenLight::TakenLight(gl::Context& context)
    : _context(context), _opacity({"levelmap/level_map.vert", "levelmap/face.geom", "levelmap/opacity.frag"}),
      _shade({"occlusion/veiled_light.comp"}),
      _apply({"occlusion/take.comp"}) {}

gl::Texture TakenLight::opacity(const LevelMap& map, const LitReceiver& receiver) {
    gl::Texture opacity(_context.ledger(), "taken light", GL_RGBA16, map.frame.size);
    const gl::Texture depth(_context.ledger(), "depth buffer", GL_DEPTH_COMPONENT32F, map.frame.size);
    const std::array<const gl::Texture*, 1> targets{&opacity};
    const gl::Framebuffer framebuffer("taken light", targets, &depth);
    framebuffer.bind();
    framebuffer.clearColor(glm::vec4(receiver.geometry.translucent() ? 0 : 1));
    if (!receiver.geometry.translucent()) return opacity;
    framebuffer.clearDepth(1);
    glEnable(GL_DEPTH_TEST);
    receiver.beams.frame.bindUniform(lightFrameBlock);
    map.box.bindUniform(boxFrameBlock);
    receiver.geometry.drawTranslucence(_opacity);
    glDisable(GL_DEPTH_TEST);
    return opacity;
}

void TakenLight::shade(const gl::Texture& share, const LevelMap& map, const LitReceiver& receiver,
                       const Occluders& occluders) {
    receiver.beams.frame.bindUniform(lightFrameBlock);
    map.box.bindUniform(boxFrameBlock);
    map.position.bind(positionMapUnit);
    map.normal.bind(normalMapUnit);
    occluders.bind();
    share.bindImage(shareImage, GL_READ_WRITE);
    _shade.set(receiverNumberLocation, receiver.number);
    glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
    _shade.dispatch2D(share.size(), groupSize);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
}

void TakenLight::apply(const gl::Texture& irradiance, const gl::Texture& share) const {
    share.bind(shareUnit);
    irradiance.bindImage(irradianceImage, GL_READ_WRITE);
    _apply.dispatch2D(share.size(), groupSize);
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
}

} // namespace limpid
