#include "view/PictureResolve.h"

#include <cmath>
#include <string>

#include "gl/Bindings.h"

namespace limpid {

namespace {
constexpr glm::ivec2 groupSize{8, 8};
} // namespace

void PictureResolve::resolve(const gl::Program& program, GLenum format, const gl::Texture& samples,
                             int perPixel) {
    const glm::ivec2 size = samples.size() / perPixel;
    if (_pixels.size() != size || _pixels.internalFormat() != format) {
        _pixels = {}; // before there is another
        _pixels = gl::Texture(_context.ledger(), "picture", format, size);
    }
    samples.bind(samplesUnit);
    _pixels.bindImage(pixelsImage, GL_WRITE_ONLY);
    program.set(perPixelLocation, perPixel);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT); // see gl::SeenBy
    program.dispatch2D(size, groupSize);
}

Picture PictureResolve::linear(const gl::Texture& samples, int perPixel) {
    if (!_linear) _linear.emplace(std::initializer_list<const char*>{"view/resolve.comp"});
    resolve(*_linear, GL_RGBA32F, samples, perPixel);
    return {_pixels.size(), _pixels.readFloats(GL_RGB, 3)};
}

std::vector<std::uint8_t> PictureResolve::toneMapped(const gl::Texture& samples, int perPixel,
                                                     double exposure) {
    const std::string defines[] = {"TONE_MAPPED"};
    if (!_toneMapped) _toneMapped.emplace(std::initializer_list<const char*>{"view/resolve.comp"}, defines);
    _toneMapped->set(gainLocation, float(std::exp2(exposure)));
    _toneMapped->set(whiteLocation, whiteLuminance);
    resolve(*_toneMapped, GL_RGBA8, samples, perPixel);
    return _pixels.readBytes(GL_RGB, 3);
}

} // namespace limpid
