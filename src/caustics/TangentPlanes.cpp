#include "caustics/TangentPlanes.h"

#include <cassert>
#include <string>
#include <vector>

#include "gl/Bindings.h"

namespace limpid {

namespace {
constexpr glm::ivec2 groupSize{8, 8};
} // namespace

TangentPlanesPass::TangentPlanesPass(gl::Context& context)
    : _context(context), _planes({"caustics/tangent_planes.comp"}) {}

const gl::Program& TangentPlanesPass::programFor(const Rims* rims) {
    if (!rims) return _planes;
    if (!_planesWithRims) {
        const std::vector<std::string> defines{"RIMS"};
        _planesWithRims = gl::Program({"caustics/tangent_planes.comp"}, defines);
    }
    _planesWithRims->set(receiverNumberLocation, rims->receiverNumber);
    rims->occluders.bind();
    rims->beams.frame.bindUniform(lightFrameBlock);
    return *_planesWithRims;
}

void TangentPlanesPass::update(TangentPlanes& planes, const LevelMap& map, const Rims* rims) {
    assert(map.position.id() != 0);
    const glm::ivec2 size = map.frame.size;
    if (!planes.planes.id() || planes.planes.size() != size) {
        gl::Ledger& ledger = _context.ledger();
        planes.planes = gl::Texture(ledger, "tangent planes", GL_RGBA32F, size);
        planes.depthPyramid = gl::Texture(ledger, "depth pyramid", GL_RGBA32F, size, gl::Mipmaps::Full);
    }
    map.box.bindUniform(boxFrameBlock);
    map.position.bind(positionMapUnit);
    map.normal.bind(normalMapUnit);
    planes.planes.bindImage(tangentPlanesImage, GL_WRITE_ONLY);
    planes.depthPyramid.bindImage(depthPyramidImage, GL_WRITE_ONLY);
    programFor(rims).dispatch2D(size, groupSize);
    _pyramid.reduce(planes.depthPyramid);
}

} // namespace limpid
