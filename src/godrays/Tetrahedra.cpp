#include "godrays/Tetrahedra.h"

#include <algorithm>

#include "core/ShaderData.h"
#include "gl/Bindings.h"

namespace limpid {

namespace {

/// Of shaders/godrays/illumination_volume.glsl, and of what draws.
constexpr int groupSize = 64;

/// Of light that meets nothing, what is followed: e^-9 of it, one in eight thousand, is left in the clearest
/// channel.
constexpr double mostExtinction = 9;
/// Of the light, what straight lines in place of its loss may be too bright by.
constexpr float mostExcess = 0.005f;

glm::ivec2 acrossOf(const GodraySettings& settings) {
    return settings.grid * settings.subdivision;
}

/// 1/m: what sub-volumes grow with, the clearest channel's extinction; what must be straight in them, that of
/// the darkest, both down to them and from there to the camera.
glm::vec3 lostIn(const Water& water) {
    const glm::dvec3 lost = water.absorption + water.scattering;
    return {std::min({lost.x, lost.y, lost.z}), 2 * std::max({lost.x, lost.y, lost.z}), mostExcess};
}

void setVolumes(const gl::Program& program, const GodrayInputs& inputs) {
    program.set(acrossLocation, acrossOf(inputs.scene.godrays));
    program.set(cutsLocation, inputs.scene.godrays.subVolumes);
    program.set(lostLocation, lostIn(inputs.scene.water));
}

} // namespace

Tetrahedra::Tetrahedra(gl::Context& context)
    : _context(context), _sweep({"godrays/illumination_volumes.comp"}),
      _pieces({"godrays/volume_pieces.comp"}), _starts({"godrays/volume_starts.comp"}),
      _draw({"godrays/tetrahedra.vert", "godrays/tetrahedra.geom", "godrays/tetrahedra.frag"}) {}

void Tetrahedra::sweep(const GodrayInputs& inputs, const GodraySource& source) {
    const glm::ivec2 across = acrossOf(inputs.scene.godrays);
    const std::int64_t corners = std::int64_t(across.x + 1) * (across.y + 1);
    const std::int64_t volumes = 2 * std::int64_t(across.x) * across.y;
    if (_rays.bytes() != corners * 32 || _flux.bytes() != volumes * 4) {
        _rays = {}, _flux = {}, _volumeStarts = {}; // free before more is asked for
        _rays = gl::Buffer(_context.ledger(), "illumination volumes", corners * 32);
        _flux = gl::Buffer(_context.ledger(), "illumination volumes", volumes * 4);
        _volumeStarts = gl::Buffer(_context.ledger(), "illumination volumes",
                                   std::int64_t(sizeof(gpu::VolumeStarts)) + volumes * 4);
    }
    bindPhotons(_sweep, inputs, source);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT); // the draw of the light before
    _rays.bindStorage(volumeRaysBuffer);
    _flux.bindStorage(volumeFluxBuffer);
    _sweep.set(reachLocation, float(godrayReach(inputs, source, mostExtinction)));
    _sweep.set(farthestLocation, float(source.farthest));
    _sweep.set(testSurfaceShadowLocation, source.beams.surfaceShadow ? 1 : 0);
    _sweep.dispatch(corners, groupSize);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

/// Which pieces there are to be drawn.
void Tetrahedra::cut(const GodrayInputs& inputs) {
    const glm::ivec2 across = acrossOf(inputs.scene.godrays);
    const int volumes = 2 * across.x * across.y;
    setVolumes(_pieces, inputs);
    _volumeStarts.bindStorage(volumeStartsBuffer);
    _pieces.dispatch(volumes, groupSize);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    _starts.set(volumesLocation, volumes);
    _starts.dispatch(1, 1);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);
}

void Tetrahedra::drawPieces(const GodrayInputs& inputs) {
    setVolumes(_draw, inputs);
    _draw.set(nearLocation, inputs.camera.viewProjection[3][2]);
    _noVertices.bind();
    _draw.use();
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, _volumeStarts.id());
    glDrawArraysIndirect(GL_POINTS, nullptr);
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, 0);
}

void Tetrahedra::draw(GodrayTarget& target, const GodrayInputs& inputs) {
    bool begun = false;
    for (const GodraySource& source : inputs.sources) {
        sweep(inputs, source);
        const gl::Buffer frame = godrayFrame(_context.ledger(), inputs, source);
        frame.bindUniform(godrayFrameBlock);
        cut(inputs);
        if (!begun) target.begin(inputs, GodrayTarget::Surface::Solid);
        begun = true;
        target.bindWithoutDepth();
        source.sceneDepth.bind();
        target.depth().bind(viewDepthUnit);
        const gl::Adding adding;
        drawPieces(inputs);
    }
}

} // namespace limpid
