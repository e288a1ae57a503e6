#include "water/HostHeights.h"

#include "gl/Bindings.h"

namespace limpid {

namespace {
constexpr glm::ivec2 groupSize{8, 8};
} // namespace

HostHeights::HostHeights(gl::Context& context) : _context(context), _program({"water/host_heights.comp"}) {
    glCreateSamplers(1, &_nearest);
    glSamplerParameteri(_nearest, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glSamplerParameteri(_nearest, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

HostHeights::~HostHeights() {
    glDeleteSamplers(1, &_nearest);
}

void HostHeights::update(gl::Texture& spline, const HeightSource& source) {
    const glm::ivec2 size = source.bounds().size;
    for (gl::Texture* texture : {&_alongX, &spline})
        if (texture->size() != size) {
            *texture = {}; // freed before more is asked for
            *texture = gl::Texture(_context.ledger(), "height map", GL_R32F, size);
            texture->setFilter(GL_NEAREST, GL_CLAMP_TO_EDGE);
        }
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT); // what the host's own passes wrote
    glBindSampler(hostHeightsUnit, _nearest);
    glBindTextureUnit(hostHeightsUnit, source.texture());
    for (const int axis : {0, 1}) {
        const gl::Texture& target = axis == 0 ? _alongX : spline;
        if (axis == 1) _alongX.bind(hostHeightsUnit);
        target.bindImage(coefficientsImage, GL_WRITE_ONLY);
        _program.set(axisLocation, axis);
        _program.dispatch2D(size, groupSize);
        glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
    }
    glBindSampler(hostHeightsUnit, 0);
}

} // namespace limpid
