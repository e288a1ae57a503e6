#include "levelmap/SceneDepthMap.h"

#include "water/FlatWater.h"

namespace limpid {

namespace {
enum Uniform { ReceiverNumber = 1, Farthest = 2, MapSize = 3, Closed = 4 };
enum Unit : GLuint { First = 1, Solid = 5, Pyramid = 6 };
constexpr glm::ivec2 groupSize{8, 8};
} // namespace

glm::vec4 sceneDepthRect(const Light& light, const Water& water, std::span<const glm::dvec3> points,
                         const glm::dvec3& origin) {
    Bounds entries;
    for (const glm::dvec3& p : points)
        entries.add(entryPoint(light, water, p) - origin);
    if (entries.empty()) return {0, 0, 1, 1};
    const glm::dvec2 size(entries.size().x, entries.size().z);
    const glm::dvec2 grown = glm::max(size * 1.01, glm::dvec2(1e-4 * std::max({size.x, size.y, 1e-6})));
    const glm::dvec2 corner = glm::dvec2(entries.center().x, entries.center().z) - 0.5 * grown;
    return glm::vec4(corner, grown);
}

void SceneDepth::bind() const {
    first.bind(First);
    if (pyramid.id()) pyramid.bind(Pyramid);
}

SceneDepthPass::SceneDepthPass(gl::Context& context)
    : _context(context),
      _first({"levelmap/scene_depth.vert", "levelmap/face.geom", "levelmap/scene_depth.frag"}),
      _exit({"levelmap/scene_depth.vert", "levelmap/face.geom", "levelmap/scene_exit.frag"}),
      _range({"levelmap/scene_depth_range.comp"}) {}

void SceneDepthPass::drawReceivers(const gl::Program& program, glm::ivec2 size, const Inputs& inputs) {
    glEnable(GL_DEPTH_TEST);
    inputs.beams.frame.bindUniform(0);
    program.set(Farthest, float(inputs.farthest));
    program.set(MapSize, size);
    for (std::size_t i = 0; i < inputs.receivers.size(); ++i) {
        program.set(ReceiverNumber, int(i));
        if (&program == &_exit) program.set(Closed, inputs.receivers[i].closed() ? 1 : 0);
        inputs.receivers[i].draw(program);
    }
    glDisable(GL_DEPTH_TEST);
}

void SceneDepthPass::drawFirst(SceneDepth& depth, glm::ivec2 size, const Inputs& inputs) {
    if (depth.first.size() != size || depth.first.id() == 0)
        depth.first = gl::Texture(_context.ledger(), "scene depth map", GL_RG32F, size);
    const gl::Texture buffer(_context.ledger(), "depth buffer", GL_DEPTH_COMPONENT32F, size);
    const gl::Texture* const targets[] = {&depth.first};
    const gl::Framebuffer framebuffer("scene depth map", targets, &buffer);
    framebuffer.bind();
    framebuffer.clearColor(0, {1e30f, -1, 0, 0});
    framebuffer.clearDepth(1);
    drawReceivers(_first, size, inputs);
}

void SceneDepthPass::drawSolids(SceneDepth& depth, const Inputs& inputs) {
    const glm::ivec2 size = depth.first.size();
    gl::Ledger& ledger = _context.ledger();
    if (depth.pyramid.size() != size || depth.pyramid.id() == 0)
        depth.pyramid = gl::Texture(ledger, "scene depth pyramid", GL_RGBA32F, size, gl::Mipmaps::Full);
    const gl::Texture solid(ledger, "scene depth pyramid", GL_RG32F, size);
    const gl::Texture buffer(ledger, "depth buffer", GL_DEPTH_COMPONENT32F, size);
    const gl::Texture* const targets[] = {&solid};
    const gl::Framebuffer framebuffer("scene solids", targets, &buffer);
    framebuffer.bind();
    framebuffer.clearColor(0, glm::vec4(0));
    framebuffer.clearDepth(1);
    depth.first.bind(First);
    drawReceivers(_exit, size, inputs);
    depth.bind();
    solid.bind(Solid);
    depth.pyramid.bindImage(0, GL_WRITE_ONLY);
    inputs.beams.frame.bindUniform(0);
    _range.dispatch2D(size, groupSize);
    _pyramid.reduce(depth.pyramid);
}

} // namespace limpid
