#include "levelmap/LevelMap.h"

#include <algorithm>
#include <array>
#include <cassert>

#include "core/ShaderData.h"
#include "gl/Bindings.h"

namespace limpid {

namespace {

constexpr glm::ivec2 groupSize{8, 8};

gl::Buffer boxFrame(gl::Ledger& ledger, const TexelFrame& frame, int planes, int facing,
                    const LevelMapLayout& layout) {
    const OrientedBox& b = frame.box;
    const Facings& facings = layout.facings;
    const DepthGradients& gradients = layout.gradients;
    gpu::BoxFrame data{
        glm::vec4(b.corner - layout.origin, 0),
        glm::vec4(b.u, 0),
        glm::vec4(b.w, 0),
        glm::vec4(b.t, 0),
        glm::vec4(b.extent, frame.texel),
        {frame.size.x, frame.size.y, planes, facing + (facings.sheet ? 8 : 0) + (facings.hollow ? 16 : 0)},
        glm::vec4(facings.light, Facings::steep),
        glm::vec4(gradients.mean, 0, 0),
        glm::vec4(gradients.least, gradients.most),
        {}};
    for (std::size_t k = 0; k < 4; ++k)
        data.facingAxes[k] = glm::vec4(facings.axes[k], facings.used[k] ? 1 : 0);
    return {ledger, "boxes", sizeof(data), &data};
}

} // namespace

void prepareLevelMap(gl::Context& context, LevelMap& map, const LevelMapLayout& layout) {
    assert(layout.mapSize >= 1 && layout.planes >= 1);
    gl::Ledger& ledger = context.ledger();
    map.frame = texelFrame(layout.box, layout.mapSize);
    const int count = map.frame.flat ? 1 : layout.planes;
    map.requestedPlanes = layout.planes;
    map.planes = uniformPlanes(map.frame.box.extent.z, count);
    map.box = boxFrame(ledger, map.frame, count, map.facing, layout);
    if (map.position.id() && map.position.size() == map.frame.size) return;
    map.position = gl::Texture(ledger, "position map", GL_RG32F, map.frame.size);
    map.diffuse = gl::Texture(ledger, "diffuse map", GL_SRGB8_ALPHA8, map.frame.size);
    map.normal = gl::Texture(ledger, "normal map", GL_RG16, map.frame.size);
}

void LitReceiver::draw(const gl::Program& program, const LevelMap& map) const {
    beams.frame.bindUniform(lightFrameBlock);
    map.box.bindUniform(boxFrameBlock);
    if (sceneDepth) sceneDepth->bind(sceneDepthUnit);
    program.set(testOcclusionLocation, sceneDepth ? 1 : 0);
    program.set(receiverNumberLocation, number);
    geometry.drawShown(program);
}

LevelMapPass::LevelMapPass(gl::Context& context)
    : _context(context),
      _program({"levelmap/level_map.vert", "levelmap/face.geom", "levelmap/level_map.frag"}) {}

void LevelMapPass::draw(LevelMap& map, const LitReceiver& receiver) {
    assert(map.position.size() == map.frame.size && "a level map that is laid out");
    const gl::Texture depth(_context.ledger(), "depth buffer", GL_DEPTH_COMPONENT32F, map.frame.size);
    const gl::Texture* const targets[] = {&map.position, &map.diffuse, &map.normal};
    const gl::Framebuffer framebuffer("level map", targets, &depth);
    framebuffer.bind();
    framebuffer.clearColor({0, -1, 0, 0}, positionTarget);
    framebuffer.clearColor(glm::vec4(0), diffuseTarget);
    framebuffer.clearColor(glm::vec4(0.5f), normalTarget);
    framebuffer.clearDepth(1);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_FRAMEBUFFER_SRGB);
    receiver.draw(_program, map);
    glDisable(GL_FRAMEBUFFER_SRGB);
    glDisable(GL_DEPTH_TEST);
}

SmartSlicing::SmartSlicing(gl::Context& context)
    : _context(context), _histogram({"levelmap/depth_histogram.comp"}),
      _assign({"levelmap/assign_planes.comp"}) {}

std::vector<std::uint32_t> SmartSlicing::histogram(const LevelMap& map, int depthLevels) {
    const std::size_t bins = depthLevels > 0 ? std::size_t(depthLevels) : map.planes.size();
    gl::Buffer counts(_context.ledger(), "depth histogram", std::int64_t(bins * sizeof(std::uint32_t)));
    counts.clearToZero();
    counts.bindStorage(histogramBuffer);
    map.box.bindUniform(boxFrameBlock);
    map.position.bind(positionMapUnit);
    _histogram.set(depthLevelsLocation, depthLevels);
    _histogram.dispatch2D(map.frame.size, groupSize);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    return counts.read<std::uint32_t>(bins);
}

void SmartSlicing::dropEmptyPlanes(LevelMap& map) {
    map.planes = occupiedPlanes(map.frame.box.extent.z, histogram(map));
}

void SmartSlicing::sliceByLevels(LevelMap& map, int depthLevels, double threshold) {
    if (map.frame.flat) return;
    const auto boxes = subBoxes(map.frame.box.extent.z, histogram(map, depthLevels), threshold);
    map.planes = planesOf(boxes);
    if (boxes.empty()) return;
    const gl::Buffer buffer(_context.ledger(), "sub-boxes", std::span<const SubBox>(boxes));
    buffer.bindStorage(subBoxesBuffer);
    map.box.bindUniform(boxFrameBlock);
    map.position.bindImage(positionMapImage, GL_READ_WRITE);
    _assign.set(boxCountLocation, int(boxes.size()));
    _assign.dispatch2D(map.frame.size, groupSize);
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
}

} // namespace limpid
