#include "view/ReceiverPass.h"

#include "water/FlatWater.h"

namespace limpid {

namespace {
constexpr glm::ivec2 groupSize{8, 8};
constexpr GLuint surfaceBinding = 1, castMapUnit = 1;
enum Uniform { Underwater, WithAmbient, WithCaustics, Strength, WayUniform };
} // namespace

ReceiverPass::ReceiverPass(gl::Context& context)
    : _context(context), _castMap({"view/cast_map.comp"}),
      _receiver({"view/receiver.vert", "view/receiver.tesc", "view/receiver.tese", "levelmap/face.geom",
                 "view/receiver.frag"}) {}

void ReceiverPass::prepare(const Inputs& inputs) {
    _casts.clear();
    for (const Lit& lit : inputs.lit) {
        gl::Texture& cast =
            _casts.emplace_back(_context.ledger(), "cast map", GL_RGBA32F, lit.level->frame.size);
        lit.caustics->irradiance.bind(0);
        lit.level->position.bind(1);
        cast.bindImage(0, GL_WRITE_ONLY);
        _castMap.dispatch2D(cast.size(), groupSize);
    }
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
}

void ReceiverPass::addCaustics(const Inputs& inputs, std::size_t receiver) {
    _receiver.set(WithCaustics, 1);
    for (std::size_t i = 0; i < inputs.lit.size(); ++i) {
        if (inputs.lit[i].receiver != int(receiver)) continue;
        inputs.lit[i].level->box.bindUniform(1);
        _casts[i].bind(castMapUnit);
        inputs.receivers[receiver].draw(_receiver, GL_PATCHES);
    }
    _receiver.set(WithCaustics, 0);
}

/// What does not go through the surface: light on what stands out of the water, and lamps below it.
void ReceiverPass::addDirectLight(const Inputs& inputs, std::size_t receiver, Side side) {
    for (std::size_t i = 0; i < inputs.scene.lights.size(); ++i) {
        const Light& light = inputs.scene.lights[i];
        if (isSubmerged(light, inputs.scene.water) != (side == Side::Below)) continue;
        inputs.lights[i]->frame.bindUniform(0);
        if (inputs.lights[i]->surfaceShadow) inputs.lights[i]->surfaceShadow->bind(surfaceShadowUnit);
        if (inputs.lights[i]->lampShadow) inputs.lights[i]->lampShadow->bind(lampShadowUnit);
        _receiver.set(Strength,
                      glm::vec3(light.type == LightType::Point ? light.intensity : light.irradiance));
        inputs.receivers[receiver].draw(_receiver, GL_PATCHES);
    }
    _receiver.set(Strength, glm::vec3(0));
}

/// One pass for each receiver and light; the first brings the ambient light, the others add to it.
void ReceiverPass::draw(const Inputs& inputs, const gl::Framebuffer& target, Side side, Way way) {
    target.bind();
    inputs.surfacePositions.bindStorage(surfaceBinding);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_GEQUAL);
    glPatchParameteri(GL_PATCH_VERTICES, 3);
    _receiver.set(Underwater, side == Side::Below ? 1 : 0);
    _receiver.set(WayUniform, int(way));
    _receiver.set(WithCaustics, 0);
    _receiver.set(Strength, glm::vec3(0));
    glBlendFunci(0, GL_ONE, GL_ONE);
    for (std::size_t i = 0; i < inputs.receivers.size(); ++i) {
        _receiver.set(WithAmbient, 1);
        inputs.receivers[i].draw(_receiver, GL_PATCHES);
        _receiver.set(WithAmbient, 0);
        glEnablei(GL_BLEND, 0);
        if (side == Side::Below) addCaustics(inputs, i);
        addDirectLight(inputs, i, side);
        glDisablei(GL_BLEND, 0);
    }
    glDepthFunc(GL_GREATER);
    glDisable(GL_DEPTH_TEST);
}

} // namespace limpid
