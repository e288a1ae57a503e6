#include "caustics/Volumetric.h"

#include "gl/Bindings.h"
#include "gl/Blending.h"

namespace limpid {

namespace {

void resize(Slices& slices, gl::Ledger& ledger, glm::ivec2 size, int count) {
    if (slices.count() == count && slices.position.size() == size) return;
    slices = {}; // all that is freed is free before more is asked for
    const gl::Layers layers{count};
    slices.position = gl::Texture(ledger, "slice images", GL_RG32F, size, layers);
    slices.diffuse = gl::Texture(ledger, "slice images", GL_SRGB8_ALPHA8, size, layers);
    slices.normal = gl::Texture(ledger, "slice images", GL_RG16, size, layers);
    slices.caustics = gl::Texture(ledger, "slice caustics", GL_RGBA32F, size, layers);
}

void bindImages(const Slices& slices) {
    slices.position.bind(positionMapUnit);
    slices.diffuse.bind(diffuseMapUnit);
    slices.normal.bind(normalMapUnit);
}

} // namespace

Volumetric::Volumetric(gl::Context& context)
    : _context(context),
      _slice({"levelmap/level_map.vert", "caustics/slice_face.geom", "caustics/slice_image.frag"}),
      _multiply({"gl/screen.vert", "caustics/slice_multiply.frag"}),
      _combine({"gl/screen.vert", "caustics/slice_combine.frag"}),
      _drawer(context, "caustics/slice_caustics.frag") {}

void Volumetric::drawSlices(Slices& slices, const LevelMap& map, const LitReceiver& receiver) {
    resize(slices, _context.ledger(), map.frame.size, int(map.planes.size()));
    const gl::Texture depth(_context.ledger(), "depth buffer", GL_DEPTH_COMPONENT32F, map.frame.size);
    const gl::Texture* const targets[] = {&slices.position, &slices.diffuse, &slices.normal};
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_FRAMEBUFFER_SRGB);
    for (int i = 0; i < slices.count(); ++i) {
        const gl::Framebuffer framebuffer("slice image", targets, &depth, i, gl::SeenBy::Draws);
        framebuffer.bind();
        framebuffer.clearColor({0, -1, 0, 0}, positionTarget);
        framebuffer.clearColor(glm::vec4(0), diffuseTarget);
        framebuffer.clearColor(glm::vec4(0.5f), normalTarget);
        framebuffer.clearDepth(1);
        _slice.set(planeNumberLocation, i);
        receiver.draw(_slice, map);
    }
    glDisable(GL_FRAMEBUFFER_SRGB);
    glDisable(GL_DEPTH_TEST);
}

void Volumetric::drawCaustics(const Slices& slices, const LevelMap& map, const Beams& beams,
                              const WaterMesh& surface, const Water& water) {
    const bool dark = beams.strength == glm::dvec3(0);
    if (!dark) _drawer.prepare(map, beams, surface, water);
    bindImages(slices);
    const gl::Texture* const targets[] = {&slices.caustics};
    for (int i = 0; i < slices.count(); ++i) {
        const gl::Framebuffer framebuffer("slice caustics", targets, nullptr, i, gl::SeenBy::Draws);
        framebuffer.clearColor(glm::vec4(0));
        if (dark) continue;
        framebuffer.bind();
        _drawer.program().set(planeNumberLocation, i);
        _drawer.draw(map.planes[std::size_t(i)]);
        multiply(i);
    }
}

void Volumetric::multiply(int plane) {
    _multiply.set(planeNumberLocation, plane);
    _multiply.use();
    _noVertices.bind();
    const gl::Multiplying multiplying;
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

void Volumetric::combine(CausticMap& caustics, LevelMap& map, const Slices& slices) {
    caustics.resize(_context, map.frame.size);
    const gl::Texture* const targets[] = {&map.position, &map.diffuse, &map.normal, &caustics.irradiance};
    const gl::Framebuffer framebuffer("combined slices", targets);
    framebuffer.bind();
    framebuffer.clearColor(glm::vec4(0), irradianceTarget);
    framebuffer.clearColor({0, -1, 0, 0}, positionTarget);
    framebuffer.clearColor(glm::vec4(0), diffuseTarget);
    framebuffer.clearColor(glm::vec4(0.5f), normalTarget);
    bindImages(slices);
    slices.caustics.bind(sliceCausticsUnit);
    _combine.set(sliceCountLocation, slices.count());
    _combine.use();
    _noVertices.bind();
    glEnable(GL_FRAMEBUFFER_SRGB);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDisable(GL_FRAMEBUFFER_SRGB);
}

} // namespace limpid
