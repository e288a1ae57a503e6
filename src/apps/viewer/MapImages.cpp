#include "apps/viewer/MapImages.h"

#include <algorithm>

#include "gl/Bindings.h"

namespace limpid::viewer {

namespace {

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
    maps.level.position.bind(positionMapUnit);
    maps.level.diffuse.bind(diffuseMapUnit);
    maps.level.normal.bind(normalMapUnit);
    maps.caustics.irradiance.bind(irradianceMapUnit);
    _program.set(sizeLocation, _size);
    _program.set(heightLocation, float(maps.level.frame.box.extent.z));
    _program.set(gainLocation, float(gain));
    _program.use();
    _noVertices.bind();
    for (int kind = 0; kind < count; ++kind) {
        gl::Texture& image = _images[std::size_t(kind)];
        const gl::Texture* const targets[] = {&image};
        const gl::Framebuffer target("window", targets);
        target.bind();
        glViewport(0, 0, _size.x, _size.y);
        _program.set(kindLocation, kind);
        glDrawArrays(GL_TRIANGLES, 0, 3);
    }
}

} // namespace limpid::viewer
