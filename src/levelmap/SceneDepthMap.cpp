#include "levelmap/SceneDepthMap.h"

#include "gl/Bindings.h"
#include "plan/FlatWater.h"

namespace limpid {

void SceneDepth::bind() const {
    first.bind(sceneDepthUnit);
}

void SceneDepthPass::draw(SceneDepth& depth, glm::ivec2 size, const Inputs& inputs) {
    if (!_program)
        _program.emplace(std::initializer_list<const char*>{"levelmap/scene_depth.vert", "levelmap/face.geom",
                                                            "levelmap/scene_depth.frag"});
    if (depth.first.size() != size || depth.first.id() == 0)
        depth.first = gl::Texture(_context.ledger(), "scene depth map", GL_RG32F, size);
    const gl::Texture buffer(_context.ledger(), "depth buffer", GL_DEPTH_COMPONENT32F, size);
    const gl::Texture* const targets[] = {&depth.first};
    const gl::Framebuffer framebuffer("scene depth map", targets, &buffer);
    framebuffer.bind();
    framebuffer.clearColor({1e30f, -1, 0, 0});
    framebuffer.clearDepth(1);
    glEnable(GL_DEPTH_TEST);
    inputs.beams.frame.bindUniform(lightFrameBlock);
    _program->set(farthestLocation, float(inputs.farthest));
    _program->set(mapSizeLocation, size);
    for (std::size_t i = 0; i < inputs.receivers.size(); ++i) {
        _program->set(receiverNumberLocation, int(i));
        inputs.receivers[i].drawSolid(*_program);
    }
    glDisable(GL_DEPTH_TEST);
}

} // namespace limpid
