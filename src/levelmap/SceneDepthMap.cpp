#include "levelmap/SceneDepthMap.h"

#include <array>

#include "water/FlatWater.h"

namespace limpid {

namespace {
enum Uniform { ReceiverNumber = 1, Farthest = 2, MapSize = 3, Closed = 4, SecondSolid = 5 };
enum Unit : GLuint { First = 1, Left = 5, Pyramid = 6, Second = 8 };
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
    if (second.id()) second.bind(Second);
}

SceneDepthPass::SceneDepthPass(gl::Context& context)
    : _context(context),
      _first({"levelmap/scene_depth.vert", "levelmap/face.geom", "levelmap/scene_depth.frag"}),
      _exit({"levelmap/scene_depth.vert", "levelmap/face.geom", "levelmap/scene_exit.frag"}),
      _range({"levelmap/scene_depth_range.comp"}),
      _rangeOfSecond({"levelmap/scene_depth_range.comp"}, std::array<std::string, 1>{"SECOND"}) {}

void SceneDepthPass::drawReceivers(const gl::Program& program, glm::ivec2 size, const Inputs& inputs,
                                   Solid solid) {
    glEnable(GL_DEPTH_TEST);
    inputs.beams.frame.bindUniform(0);
    program.set(Farthest, float(inputs.farthest));
    program.set(MapSize, size);
    program.set(SecondSolid, solid == Solid::Second ? 1 : 0);
    for (std::size_t i = 0; i < inputs.receivers.size(); ++i) {
        program.set(ReceiverNumber, int(i));
        if (&program == &_exit) program.set(Closed, inputs.receivers[i].closed() ? 1 : 0);
        inputs.receivers[i].drawSolid(program);
    }
    glDisable(GL_DEPTH_TEST);
}

void SceneDepthPass::drawEntered(const gl::Texture& entered, const Inputs& inputs, Solid solid) {
    const gl::Texture buffer(_context.ledger(), "depth buffer", GL_DEPTH_COMPONENT32F, entered.size());
    const gl::Texture* const targets[] = {&entered};
    const gl::Framebuffer framebuffer("scene depth map", targets, &buffer);
    framebuffer.bind();
    framebuffer.clearColor(0, {1e30f, -1, 0, 0});
    framebuffer.clearDepth(1);
    drawReceivers(_first, entered.size(), inputs, solid);
}

void SceneDepthPass::drawLeft(const gl::Texture& entered, const gl::Texture& out, const Inputs& inputs,
                              Solid solid) {
    const glm::ivec2 size = entered.size();
    const gl::Texture left(_context.ledger(), "scene solids", GL_RG32F, size);
    const gl::Texture buffer(_context.ledger(), "depth buffer", GL_DEPTH_COMPONENT32F, size);
    const gl::Texture* const targets[] = {&left};
    const gl::Framebuffer framebuffer("scene solids", targets, &buffer);
    framebuffer.bind();
    framebuffer.clearColor(0, glm::vec4(0));
    framebuffer.clearDepth(1);
    entered.bind(First);
    drawReceivers(_exit, size, inputs, solid);
    left.bind(Left);
    out.bindImage(0, GL_WRITE_ONLY);
    inputs.beams.frame.bindUniform(0);
    (solid == Solid::First ? _range : _rangeOfSecond).dispatch2D(size, groupSize);
}

void SceneDepthPass::drawFirst(SceneDepth& depth, glm::ivec2 size, const Inputs& inputs) {
    if (depth.first.size() != size || depth.first.id() == 0)
        depth.first = gl::Texture(_context.ledger(), "scene depth map", GL_RG32F, size);
    drawEntered(depth.first, inputs, Solid::First);
}

void SceneDepthPass::drawSolids(SceneDepth& depth, const Inputs& inputs) {
    const glm::ivec2 size = depth.first.size();
    if (depth.pyramid.size() != size || depth.pyramid.id() == 0)
        depth.pyramid =
            gl::Texture(_context.ledger(), "scene depth pyramid", GL_RGBA32F, size, gl::Mipmaps::Full);
    drawLeft(depth.first, depth.pyramid, inputs, Solid::First);
    _pyramid.reduce(depth.pyramid);
}

void SceneDepthPass::drawSecondSolids(SceneDepth& depth, const Inputs& inputs) {
    const glm::ivec2 size = depth.first.size();
    if (depth.second.size() != size || depth.second.id() == 0)
        depth.second = gl::Texture(_context.ledger(), "second solids", GL_RG32F, size);
    depth.pyramid.bind(Pyramid);
    const gl::Texture beyond(_context.ledger(), "scene depth map", GL_RG32F, size);
    drawEntered(beyond, inputs, Solid::Second);
    drawLeft(beyond, depth.second, inputs, Solid::Second);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
}

} // namespace limpid
