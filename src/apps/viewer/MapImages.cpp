#include "apps/viewer/MapImages.h"

#include <algorithm>

namespace limpid::viewer {

namespace {

enum Uniform { Size, KindUniform, Height, Gain };
constexpr int largestSide = 512;

glm::ivec2 imageSize(glm::ivec2 map) {
    const double share = std::min(1.0, double(largestSide) / std::max(map.x, map.y));
    return glm::max(glm::ivec2(share * glm::dvec2(map)), 1);
}

} // namespace

MapImages::MapImages(gl::Context& context)
    : _context(context), _program({"gl/screen.vert", "viewer/map.frag"}) {
    for (gl::Texture& image : _images) {
        image = gl::Texture(_context.ledger(), "window", GL_RGBA8, glm::ivec2(largestSide));
        image.setFilter(GL_LINEAR, GL_CLAMP_TO_EDGE);
    }
}

void MapImages::update(const MapWork& maps, double gain) {
    _size = imageSize(maps.level.frame.size);
    maps.level.position.bind(0);
    maps.level.diffuse.bind(1);
    maps.level.normal.bind(2);
    maps.caustics.irradiance.bind(3);
    _program.set(Size, _size);
    _program.set(Height, float(maps.level.frame.box.extent.z));
    _program.set(Gain, float(gain));
    _program.use();
    _noVertices.bind();
    for (int kind = 0; kind < count; ++kind) {
        gl::Texture& image = _images[std::size_t(kind)];
        const gl::Texture* const targets[] = {&image};
        const gl::Framebuffer target("window", targets);
        target.bind();
        glViewport(0, 0, _size.x, _size.y);
        _program.set(KindUniform, kind);
        glDrawArrays(GL_TRIANGLES, 0, 3);
    }
}

} // namespace limpid::viewer
