#include "godrays/PhotonLines.h"

#include <cmath>

#include "gl/Bindings.h"

namespace limpid {

namespace {

constexpr int groupSize = 64;

/// Of light that meets nothing, what is followed: e^-12 of it is left in the clearest channel.
constexpr double mostExtinction = 12;

int lineCount(const GodraySettings& settings) {
    return settings.grid.x * settings.grid.y * settings.subdivision * settings.subdivision;
}

} // namespace

PhotonLines::PhotonLines(gl::Context& context)
    : _context(context), _cast({"godrays/photon_lines.comp"}),
      _lines({"godrays/photon_line.vert", "godrays/photon_line.frag"}) {}

void PhotonLines::castLines(const GodrayInputs& inputs, const GodraySource& source) {
    const GodraySettings& settings = inputs.scene.godrays;
    const std::int64_t bytes = std::int64_t(lineCount(settings)) * 2 * std::int64_t(sizeof(glm::vec4));
    if (_ends.bytes() != bytes) _ends = gl::Buffer(_context.ledger(), "photon lines", bytes);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT); // the draw of the light before
    bindPhotons(_cast, inputs, source);
    _ends.bindStorage(photonLinesBuffer);
    _cast.set(reachLocation, float(godrayReach(inputs, source, mostExtinction)));
    _cast.set(farthestLocation, float(source.farthest));
    _cast.set(testSurfaceShadowLocation, source.beams.surfaceShadow ? 1 : 0);
    _cast.dispatch(std::int64_t(settings.grid.x) * settings.grid.y, groupSize);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

void PhotonLines::drawLines(const GodrayInputs& inputs) {
    const GodraySettings& settings = inputs.scene.godrays;
    const glm::dvec2 piece = inputs.patch.size / glm::dvec2(settings.grid * settings.subdivision);
    _lines.set(lineWidthLocation, glm::vec2(settings.lineWidth, std::sqrt(piece.x * piece.y)));
    _ends.bindStorage(photonLinesBuffer);
    _noVertices.bind();
    _lines.use();
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, lineCount(settings));
}

void PhotonLines::draw(GodrayTarget& target, const GodrayInputs& inputs) {
    bool begun = false;
    for (const GodraySource& source : inputs.sources) {
        castLines(inputs, source);
        const gl::Buffer frame = godrayFrame(_context.ledger(), inputs, source);
        frame.bindUniform(godrayFrameBlock);
        if (!begun) target.begin(inputs, GodrayTarget::Surface::Blended);
        begun = true;
        target.bind();
        const NearIsOneTested reversed;
        const AddingBehindDepth adding;
        drawLines(inputs);
    }
}

} // namespace limpid
