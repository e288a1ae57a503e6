#include "apps/viewer/Display.h"

#include <cmath>

#include "gl/Bindings.h"

namespace limpid::viewer {

Display::Display(gl::Context& context)
    : _context(context), _program({"gl/screen.vert", "viewer/show.frag"}) {}

void Display::show(const PicturePass::Sketch& first, const PicturePass::Sketch* second, const Shown& shown) {
    const glm::ivec2 size = first.samples().size() / first.perPixel();
    if (!_picture.id() || _picture.size() != size) {
        _picture = gl::Texture(_context.ledger(), "window", GL_RGBA8, size);
        _picture.setFilter(GL_LINEAR, GL_CLAMP_TO_EDGE);
        const gl::Texture* const targets[] = {&_picture};
        _target = gl::Framebuffer("window", targets);
    }
    _target.bind();
    first.samples().bind(firstRadianceUnit);
    (second ? *second : first).samples().bind(secondRadianceUnit);
    _program.set(sizeLocation, size);
    _program.set(perPixelLocation, first.perPixel());
    _program.set(gainLocation, float(std::exp2(shown.exposure)));
    _program.set(modeLocation, second ? int(shown.mode) : 0);
    _program.set(splitLocation, float(shown.split * size.x));
    _program.set(differenceLocation, float(shown.difference));
    _program.set(whiteLocation, whiteLuminance);
    _program.use();
    _noVertices.bind();
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

std::vector<std::uint8_t> Display::pixels() const {
    const glm::ivec2 size = _picture.size();
    const auto values = _picture.readFloats(GL_RGBA, 4);
    std::vector<std::uint8_t> out(std::size_t(size.x) * std::size_t(size.y) * 3);
    for (std::size_t y = 0; y < std::size_t(size.y); ++y)
        for (std::size_t x = 0; x < std::size_t(size.x); ++x)
            for (std::size_t c = 0; c < 3; ++c) {
                const std::size_t from = 4 * ((std::size_t(size.y) - 1 - y) * std::size_t(size.x) + x) + c;
                out[3 * (y * std::size_t(size.x) + x) + c] = std::uint8_t(std::lround(255 * values[from]));
            }
    return out;
}

} // namespace limpid::viewer
