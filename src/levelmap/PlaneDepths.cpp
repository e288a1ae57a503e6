#include "levelmap/PlaneDepths.h"

#include <algorithm>
#include <cassert>
#include <vector>

#include "gl/Bindings.h"

namespace limpid {

namespace {

constexpr glm::ivec2 groupSize{8, 8};

/// As the drawn form has them: in single precision.
std::vector<float> depthsByIndex(const LevelMap& map) {
    std::vector<float> depths(1);
    for (const ReferencePlane& plane : map.planes) {
        depths.resize(std::max(depths.size(), std::size_t(plane.index) + 1));
        depths[std::size_t(plane.index)] = float(plane.depth);
    }
    return depths;
}

} // namespace

PlaneDepthsPass::PlaneDepthsPass(gl::Context& context)
    : _context(context), _program({"levelmap/plane_depths.comp"}) {}

void PlaneDepthsPass::update(PlaneDepths& depths, const LevelMap& map) {
    assert(map.position.id() != 0);
    gl::Ledger& ledger = _context.ledger();
    if (!depths.pyramid.id() || depths.pyramid.size() != map.frame.size)
        depths.pyramid = gl::Texture(ledger, "plane depths", GL_RGBA32F, map.frame.size, gl::Mipmaps::Full);
    const gl::Buffer planes(ledger, "planes", std::span<const float>(depthsByIndex(map)));
    map.box.bindUniform(boxFrameBlock);
    map.position.bind(positionMapUnit);
    planes.bindStorage(planesBuffer);
    depths.pyramid.bindImage(depthPyramidImage, GL_WRITE_ONLY);
    _program.dispatch2D(map.frame.size, groupSize);
    _pyramid.reduce(depths.pyramid);
}

} // namespace limpid
