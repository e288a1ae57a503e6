#include "godrays/PhotonLines.h"

#include <algorithm>
#include <cmath>

#include "gl/NearIsOne.h"
#include "water/FlatWater.h"

namespace limpid {

namespace {

enum CastUniform { PatchRect, Quads, PhotonRect, Cells, Subdivision, Reach, Farthest, TestSurfaceShadow };
constexpr int groupSize = 64;
constexpr GLuint frameBinding = 2, linesBinding = 6;

/// Of light that meets nothing, what is followed: e^-12 of it is left in the clearest channel.
constexpr double mostExtinction = 12;

/// LineFrame of shaders/include/line_frame.glsl (std140).
struct LineFrameData {
    glm::mat4 viewProjection;
    glm::vec4 cameraPosition, target, lineWidth, strength, scattering, extinction;
};

int lineCount(const GodraySettings& settings) {
    return settings.grid.x * settings.grid.y * settings.subdivision * settings.subdivision;
}

/// m that light is followed: until it is gone, or has left all that a camera among the receivers can see.
double reachOf(const PhotonLines::Inputs& inputs, const PhotonLines::Source& source) {
    const glm::dvec3 lost = inputs.scene.water.absorption + inputs.scene.water.scattering;
    const double least = std::min({lost.x, lost.y, lost.z});
    const double far = 20 * (source.farthest + glm::length(inputs.patch.size));
    return least > 0 ? std::min(far, mostExtinction / least) : far;
}

} // namespace

glm::ivec2 godrayTargetSize(glm::ivec2 size, double scale) {
    return glm::max(glm::ivec2(glm::round(glm::dvec2(size) * scale)), 1);
}

PhotonLines::PhotonLines(gl::Context& context)
    : _context(context), _cast({"godrays/photon_lines.comp"}),
      _lines({"godrays/photon_line.vert", "godrays/photon_line.frag"}),
      _depth({"godrays/view_depth.vert", "levelmap/face.geom", "godrays/view_depth.frag"}),
      _surface({"godrays/view_surface.vert", "godrays/view_surface.frag"}) {}

void PhotonLines::castLines(const Inputs& inputs, const Source& source) {
    const GodraySettings& settings = inputs.scene.godrays;
    const std::int64_t bytes = std::int64_t(lineCount(settings)) * 2 * std::int64_t(sizeof(glm::vec4));
    if (_ends.bytes() != bytes) _ends = gl::Buffer(_context.ledger(), "photon lines", bytes);
    source.beams.frame.bindUniform(0);
    source.sceneDepth.bind();
    if (source.beams.surfaceShadow) source.beams.surfaceShadow->bind(surfaceShadowUnit);
    inputs.surface.indices.bindStorage(0);
    source.beams.origins.bindStorage(3);
    source.beams.directions.bindStorage(4);
    source.beams.flux.bindStorage(5);
    _ends.bindStorage(linesBinding);
    const glm::vec4 rect = rectOf(inputs.patch, inputs.origin);
    _cast.set(PatchRect, rect);
    _cast.set(Quads, inputs.surface.quads);
    _cast.set(PhotonRect, rect);
    _cast.set(Cells, settings.grid);
    _cast.set(Subdivision, settings.subdivision);
    _cast.set(Reach, float(reachOf(inputs, source)));
    _cast.set(Farthest, float(source.farthest));
    _cast.set(TestSurfaceShadow, source.beams.surfaceShadow ? 1 : 0);
    _cast.dispatch(std::int64_t(settings.grid.x) * settings.grid.y, groupSize);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

gl::Buffer PhotonLines::lineFrame(const Inputs& inputs, const Source& source) const {
    const GodraySettings& settings = inputs.scene.godrays;
    const Water& water = inputs.scene.water;
    const glm::dvec2 target(godrayTargetSize(inputs.camera.size, settings.scale));
    const glm::mat4& view = inputs.camera.viewProjection;
    // The projection's scales are the lengths of its rows: what turns the view is orthonormal.
    const glm::dvec2 focus(glm::length(glm::dvec3(view[0][0], view[1][0], view[2][0])),
                           glm::length(glm::dvec3(view[0][1], view[1][1], view[2][1])));
    const glm::dvec2 piece = inputs.patch.size / glm::dvec2(settings.grid * settings.subdivision);
    LineFrameData data;
    data.viewProjection = view;
    data.cameraPosition = glm::vec4(inputs.camera.position, view[3][2] * 1.001f);
    data.target = glm::vec4(target, 0.5 * target * focus);
    data.lineWidth = glm::vec4(settings.lineWidth, std::sqrt(piece.x * piece.y), 0, 0);
    data.strength = glm::vec4(source.beams.strength, settings.phase == Phase::Schlick ? 1 : 0);
    data.scattering = glm::vec4(water.scattering, water.anisotropy);
    data.extinction = glm::vec4(water.absorption + water.scattering, 0);
    return {_context.ledger(), "view", sizeof(data), &data};
}

/// What ends a view ray: receivers, and seen from below the surface. That one hides no line, as lines end
/// there, and what is drawn wider than it is would lose its rim.
void PhotonLines::drawDepth(const Inputs& inputs) {
    for (const ReceiverGeometry& receiver : inputs.receivers)
        receiver.draw(_depth);
    gl::VertexArray grid;
    grid.attribute(0, inputs.surface.positions, 4, 0, sizeof(glm::vec4));
    grid.indices(inputs.surface.indices);
    grid.bind();
    _surface.use();
    glDepthMask(GL_FALSE);
    glDrawElements(GL_TRIANGLES, 3 * inputs.surface.triangleCount, GL_UNSIGNED_INT, nullptr);
    glDepthMask(GL_TRUE);
}

const gl::Texture& PhotonLines::draw(const Inputs& inputs) {
    gl::Ledger& ledger = _context.ledger();
    const glm::ivec2 size = godrayTargetSize(inputs.camera.size, inputs.scene.godrays.scale);
    if (_radiance.id() == 0 || _radiance.size() != size) {
        _radiance = gl::Texture(ledger, "godrays", GL_RGBA32F, size);
        _radiance.setFilter(GL_LINEAR, GL_CLAMP_TO_EDGE);
    }
    const gl::Texture depth(ledger, "depth buffer", GL_DEPTH_COMPONENT32F, size);
    const gl::Texture* const targets[] = {&_radiance};
    const gl::Framebuffer framebuffer("godrays", targets, &depth);
    framebuffer.clearColor(0, glm::vec4(0));
    framebuffer.clearDepth(0);
    bool depthDrawn = false;
    for (const Source& source : inputs.sources) {
        castLines(inputs, source);
        const gl::Buffer frame = lineFrame(inputs, source);
        frame.bindUniform(frameBinding);
        framebuffer.bind();
        const gl::NearIsOne reversed;
        glEnable(GL_DEPTH_TEST);
        if (!depthDrawn) drawDepth(inputs);
        depthDrawn = true;
        glDepthMask(GL_FALSE);
        glEnable(GL_BLEND);
        glBlendFunc(GL_ONE, GL_ONE);
        _ends.bindStorage(linesBinding);
        _noVertices.bind();
        _lines.use();
        glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, lineCount(inputs.scene.godrays));
        glDisable(GL_BLEND);
        glDepthMask(GL_TRUE);
        glDisable(GL_DEPTH_TEST);
    }
    return _radiance;
}

} // namespace limpid
