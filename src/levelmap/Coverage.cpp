#include "levelmap/Coverage.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/ShaderData.h"
#include "gl/Bindings.h"

namespace limpid {

namespace {

constexpr glm::ivec2 groupSize{8, 8};
const double lean = gpu::coverageLean;
constexpr int mostPlaces = 4096;

/// Along a texel's side: as many as leave 2e-4 of a square map in doubt. Each of 4 `side` texels at a rim is
/// off by some 0.3 of a place, by chance.
double placesFor(glm::ivec2 size) {
    const double side = std::max(size.x, size.y);
    const double wanted = 0.6 / (2e-4 * side * std::sqrt(side));
    return std::min(std::clamp(wanted, 3.0, 16.0), mostPlaces / ((1 + lean) * side));
}

glm::ivec2 gridFor(glm::ivec2 size, double places) {
    const glm::dvec2 texels(size);
    return glm::ivec2(glm::ceil(places * (texels + lean * glm::dvec2(texels.y, texels.x))));
}

} // namespace

CoveragePass::CoveragePass(gl::Context& context)
    : _context(context), _draw({"levelmap/coverage.vert", "levelmap/face.geom", "levelmap/coverage.frag"}),
      _share({"levelmap/coverage.comp"}) {}

gl::Texture CoveragePass::draw(const LevelMap& map, const ReceiverGeometry& geometry, const Beams& beams) {
    const glm::ivec2 size = map.frame.size;
    const double places = placesFor(size);
    const glm::ivec2 grid = gridFor(size, places);
    const gl::Texture covered(_context.ledger(), "coverage", GL_R8, grid);
    beams.frame.bindUniform(lightFrameBlock);
    map.box.bindUniform(boxFrameBlock);
    map.position.bind(positionMapUnit);
    map.normal.bind(normalMapUnit);
    _draw.set(placesLocation, float(places));
    _draw.set(gridPlacesLocation, glm::vec2(grid));
    drawPlaces(covered, geometry);
    gl::Texture coverage(_context.ledger(), "coverage", GL_R32F, size);
    covered.bind(coveredUnit);
    coverage.bindImage(coverageImage, GL_WRITE_ONLY);
    _share.set(placesLocation, float(places));
    _share.dispatch2D(size, groupSize);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT);
    return coverage;
}

void CoveragePass::drawPlaces(const gl::Texture& covered, const ReceiverGeometry& geometry) {
    const gl::Texture depth(_context.ledger(), "depth buffer", GL_DEPTH_COMPONENT32F, covered.size());
    const std::array<const gl::Texture*, 1> targets{&covered};
    const gl::Framebuffer framebuffer("coverage", targets, &depth);
    framebuffer.bind();
    framebuffer.clearColor(glm::vec4(0));
    framebuffer.clearDepth(1);
    glEnable(GL_DEPTH_TEST);
    geometry.drawShown(_draw);
    glDisable(GL_DEPTH_TEST);
}

} // namespace limpid
