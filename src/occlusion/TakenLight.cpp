#include "occlusion/TakenLight.h"

#include <array>

namespace limpid {

namespace {
enum ShadeUniform { ReceiverNumber };
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
    framebuffer.clearColor(0, glm::vec4(receiver.geometry.translucent() ? 0 : 1));
    if (!receiver.geometry.translucent()) return opacity;
    framebuffer.clearDepth(1);
    glEnable(GL_DEPTH_TEST);
    receiver.beams.frame.bindUniform(0);
    map.box.bindUniform(1);
    receiver.geometry.drawTranslucence(_opacity);
    glDisable(GL_DEPTH_TEST);
    return opacity;
}

void TakenLight::shade(const gl::Texture& share, const LevelMap& map, const LitReceiver& receiver,
                       const Occluders& occluders) {
    receiver.beams.frame.bindUniform(0);
    map.box.bindUniform(1);
    map.position.bind(0);
    map.normal.bind(2);
    occluders.bind();
    share.bindImage(0, GL_READ_WRITE);
    _shade.set(ReceiverNumber, receiver.number);
    glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
    _shade.dispatch2D(share.size(), groupSize);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
}

void TakenLight::apply(const gl::Texture& irradiance, const gl::Texture& share) const {
    share.bind(0);
    irradiance.bindImage(0, GL_READ_WRITE);
    _apply.dispatch2D(share.size(), groupSize);
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
}

} // namespace limpid
