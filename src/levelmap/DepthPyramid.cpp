#include "levelmap/DepthPyramid.h"

#include "gl/Bindings.h"

namespace limpid {

namespace {
constexpr glm::ivec2 groupSize{8, 8};
} // namespace

DepthPyramidPass::DepthPyramidPass() : _program({"levelmap/depth_pyramid.comp"}) {}

void DepthPyramidPass::reduce(gl::Texture& pyramid) {
    for (int level = 1; level < pyramid.levels(); ++level) {
        glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
        pyramid.bindImage(finerImage, GL_READ_ONLY, level - 1);
        pyramid.bindImage(coarserImage, GL_WRITE_ONLY, level);
        _program.dispatch2D(glm::max(pyramid.size() >> level, 1), groupSize);
    }
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
}

} // namespace limpid
