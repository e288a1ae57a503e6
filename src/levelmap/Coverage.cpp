#include "levelmap/Coverage.h"

#include <algorithm>
#include <array>

namespace limpid {

namespace {

enum MeanUniform { Places };
constexpr glm::ivec2 groupSize{8, 8};

/// Along a texel's side; odd, so that its middle is one.
int placesFor(glm::ivec2 size) {
    const int most = std::clamp(4096 / std::max(size.x, size.y), 1, 7);
    return most % 2 == 0 ? most - 1 : most;
}

} // namespace

CoveragePass::CoveragePass(gl::Context& context)
    : _context(context), _draw({"levelmap/level_map.vert", "levelmap/face.geom", "levelmap/coverage.frag"}),
      _mean({"levelmap/coverage.comp"}) {}

gl::Texture CoveragePass::draw(const LevelMap& map, const ReceiverGeometry& geometry, const Beams& beams) {
    const glm::ivec2 size = map.frame.size;
    const int places = placesFor(size);
    const gl::Texture covered(_context.ledger(), "coverage", GL_R8, places * size);
    const std::array<const gl::Texture*, 1> targets{&covered};
    const gl::Framebuffer framebuffer("coverage", targets);
    framebuffer.bind();
    framebuffer.clearColor(0, glm::vec4(0));
    beams.frame.bindUniform(0);
    map.box.bindUniform(1);
    geometry.draw(_draw);
    gl::Texture coverage(_context.ledger(), "coverage", GL_R32F, size);
    covered.bind(0);
    coverage.bindImage(0, GL_WRITE_ONLY);
    _mean.set(Places, places);
    _mean.dispatch2D(size, groupSize);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT);
    return coverage;
}

} // namespace limpid
