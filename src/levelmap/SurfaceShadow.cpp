#include "levelmap/SurfaceShadow.h"

#include <algorithm>

#include "gl/Blending.h"

namespace limpid {

namespace {

constexpr glm::ivec2 mapSize{2048, 2048};

/// Where the straight light through `point` meets the level.
glm::dvec3 straightFoot(const Light& light, const Water& water, const glm::dvec3& point) {
    const glm::dvec3 way = light.type == LightType::Directional ? light.direction : point - light.position;
    return point + way * ((point.y - water.level) / std::max(-way.y, 1e-6 * glm::length(way)));
}

} // namespace

glm::vec4 surfaceShadowRect(const Light& light, const Water& water, const WaterPatch& patch,
                            std::span<const glm::dvec3> dry, const glm::dvec3& origin) {
    if (!entersWater(light, water)) return glm::vec4(0);
    const glm::dvec2 low = patch.min() - 0.5 * patch.size, high = patch.min() + 1.5 * patch.size;
    glm::dvec2 min(1e300), max(-1e300);
    for (const glm::dvec3& p : dry) {
        const glm::dvec3 foot = straightFoot(light, water, p);
        const glm::dvec2 at = glm::clamp(glm::dvec2(foot.x, foot.z), low, high);
        min = glm::min(min, at);
        max = glm::max(max, at);
    }
    const glm::dvec2 size = (max - min) * 1.02;
    if (dry.empty() || !(size.x > 0) || !(size.y > 0)) return glm::vec4(0);
    const glm::dvec2 corner = 0.5 * (min + max) - 0.5 * size - glm::dvec2(origin.x, origin.z);
    return glm::vec4(corner, size);
}

SurfaceShadowPass::SurfaceShadowPass(gl::Context& context)
    : _context(context),
      _program({"levelmap/surface_shadow.vert", "levelmap/face.geom", "levelmap/surface_shadow.frag"}) {}

void SurfaceShadowPass::draw(gl::Texture& map, const Beams& beams,
                             std::span<const ReceiverGeometry> receivers) {
    if (!map.id()) map = gl::Texture(_context.ledger(), "surface shadow map", GL_R32F, mapSize);
    const gl::Texture* const targets[] = {&map};
    const gl::Framebuffer framebuffer("surface shadow map", targets);
    framebuffer.bind();
    framebuffer.clearColor(0, glm::vec4(0));
    beams.frame.bindUniform(0);
    const gl::Blending greatest(GL_ONE, GL_ONE, GL_MAX);
    for (const ReceiverGeometry& receiver : receivers)
        receiver.draw(_program);
}

} // namespace limpid
