#include "view/ReceiverPass.h"

#include <algorithm>

#include "gl/Bindings.h"
#include "plan/FlatWater.h"

namespace limpid {

namespace {
constexpr glm::ivec2 groupSize{8, 8};
} // namespace

ReceiverPass::ReceiverPass(gl::Context& context)
    : _context(context), _castMap({"view/cast_map.comp"}),
      _receiver({"view/receiver.vert", "view/receiver.tesc", "view/receiver.tese", "levelmap/face.geom",
                 "view/receiver.frag"}) {}

void ReceiverPass::prepare(const Inputs& inputs) {
    std::vector<Stamp> sources;
    for (const Lit& lit : inputs.lit)
        sources.push_back(lit.filled);
    if (sources == _castsOf) return;
    _castsOf.clear();
    _casts.clear();
    for (const Lit& lit : inputs.lit) {
        gl::Texture& cast =
            _casts.emplace_back(_context.ledger(), "cast map", GL_RGBA32F, lit.level->frame.size);
        lit.caustics->irradiance.bind(irradianceMapUnit);
        lit.level->position.bind(positionMapUnit);
        cast.bindImage(castMapImage, GL_WRITE_ONLY);
        _castMap.dispatch2D(cast.size(), groupSize);
    }
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
    _castsOf = std::move(sources);
}

void ReceiverPass::drawOnce(const Inputs& inputs, const Drawn& drawn) {
    const ReceiverGeometry& receiver = inputs.receivers[drawn.receiver];
    if (drawn.blended)
        receiver.drawPart(drawn.blended->part, _receiver, GL_PATCHES);
    else
        receiver.drawSolid(_receiver, GL_PATCHES);
}

void ReceiverPass::addCaustics(const Inputs& inputs, const Drawn& drawn) {
    _receiver.set(withCausticsLocation, 1);
    for (std::size_t i = 0; i < inputs.lit.size(); ++i) {
        if (inputs.lit[i].receiver != int(drawn.receiver)) continue;
        inputs.lit[i].level->box.bindUniform(boxFrameBlock);
        _casts[i].bind(castMapUnit);
        drawOnce(inputs, drawn);
    }
    _receiver.set(withCausticsLocation, 0);
}

/// What does not go through the surface: light on what stands out of the water, and point lights below it.
void ReceiverPass::addDirectLight(const Inputs& inputs, const Drawn& drawn, Side side) {
    for (std::size_t i = 0; i < inputs.scene.lights.size(); ++i) {
        const Light& light = inputs.scene.lights[i];
        if (isSubmerged(light, inputs.scene.water) != (side == Side::Below)) continue;
        inputs.lights[i]->frame.bindUniform(lightFrameBlock);
        if (inputs.lights[i]->surfaceShadow) inputs.lights[i]->surfaceShadow->bind(surfaceShadowUnit);
        if (inputs.lights[i]->pointLightShadow)
            inputs.lights[i]->pointLightShadow->bind(pointLightShadowUnit);
        _receiver.set(strengthLocation,
                      glm::vec3(light.type == LightType::Point ? light.intensity : light.irradiance));
        drawOnce(inputs, drawn);
    }
    _receiver.set(strengthLocation, glm::vec3(0));
}

/// One pass for each light; the first brings the ambient light, the others add to it.
void ReceiverPass::drawLit(const Inputs& inputs, const Drawn& drawn, Side side) {
    if (drawn.blended) glEnablei(GL_BLEND, 0);
    glBlendFunci(0, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    _receiver.set(withAmbientLocation, 1);
    drawOnce(inputs, drawn);
    _receiver.set(withAmbientLocation, 0);
    glEnablei(GL_BLEND, 0);
    glBlendFunci(0, GL_ONE, GL_ONE);
    if (side == Side::Below) addCaustics(inputs, drawn);
    addDirectLight(inputs, drawn, side);
    glDisablei(GL_BLEND, 0);
}

void ReceiverPass::begin(const Inputs& inputs, const gl::Framebuffer& target, Side side, Way way) {
    target.bind();
    inputs.surfacePositions.bindStorage(positionsBuffer);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_GEQUAL);
    glPatchParameteri(GL_PATCH_VERTICES, 3);
    _receiver.set(underwaterLocation, side == Side::Below ? 1 : 0);
    _receiver.set(wayLocation, int(way));
    _receiver.set(blendedSideLocation, 0);
    _receiver.set(withCausticsLocation, 0);
    _receiver.set(strengthLocation, glm::vec3(0));
}

void ReceiverPass::end() {
    glDepthFunc(GL_GREATER);
    glDisable(GL_DEPTH_TEST);
}

void ReceiverPass::drawSolid(const Inputs& inputs, const gl::Framebuffer& target, Side side, Way way) {
    begin(inputs, target, side, way);
    for (std::size_t i = 0; i < inputs.receivers.size(); ++i)
        drawLit(inputs, {i}, side);
    end();
}

/// From the farthest part to the nearest, of each the back first.
void ReceiverPass::drawBlended(const Inputs& inputs, const gl::Framebuffer& target, Side side, Way way) {
    std::vector<Drawn> parts;
    for (std::size_t i = 0; i < inputs.receivers.size(); ++i)
        for (const ReceiverGeometry::BlendedPart& part : inputs.receivers[i].blendedParts())
            parts.push_back({i, &part});
    const auto far = [&](const Drawn& d) { return glm::distance(d.blended->center, inputs.camera); };
    std::stable_sort(parts.begin(), parts.end(),
                     [&](const Drawn& a, const Drawn& b) { return far(a) > far(b); });
    if (parts.empty()) return;
    begin(inputs, target, side, way);
    glDepthMask(GL_FALSE);
    // Rays are followed to what is solid, and to a sheet only where nothing is behind it.
    glEnablei(GL_BLEND, 1);
    glBlendEquationi(1, GL_MAX);
    for (const Drawn& part : parts)
        for (const int seenFrom : {-1, 1}) {
            _receiver.set(blendedSideLocation, seenFrom);
            drawLit(inputs, part, side);
        }
    _receiver.set(blendedSideLocation, 0);
    glBlendEquationi(1, GL_FUNC_ADD);
    glDisablei(GL_BLEND, 1);
    glDepthMask(GL_TRUE);
    end();
}

} // namespace limpid
