#include "plan/LightFrame.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace limpid {

namespace {

/// Where the straight light through `point` meets the level.
glm::dvec3 straightFoot(const Light& light, const Water& water, const glm::dvec3& point) {
    const glm::dvec3 way = light.type == LightType::Directional ? light.direction : point - light.position;
    return point + way * ((point.y - water.level) / std::max(-way.y, 1e-6 * glm::length(way)));
}

} // namespace

LightFrameData::LightFrameData()
    : gpu::LightFrame{.lightPosition = glm::vec4(0),
                      .lightDirection = {0, -1, 0, 0},
                      .lightRefracted = {0, -1, 0, 0},
                      .sceneDepthRect = {0, 0, 1, 1},
                      .waterSurface = {0, 1.333, 0, 0},
                      .surfaceShadowRect = glm::vec4(0),
                      .lightCone = {-2, -3, 0, 0}} {}

bool LightFrameData::operator==(const LightFrameData& other) const {
    return std::memcmp(this, &other, sizeof(*this)) == 0; // vectors of four alone: no gaps
}

LightFrameData lightFrame(const Light& light, const Water& water, const glm::dvec3& origin) {
    LightFrameData frame;
    frame.lightPosition = glm::vec4(light.position - origin, light.type == LightType::Point ? 1 : 0);
    const bool enters = entersWater(light, water);
    if (light.type == LightType::Directional && enters) {
        frame.lightDirection = glm::vec4(glm::normalize(light.direction), 0);
        frame.lightRefracted = glm::vec4(refractedAt(light, water, {}), 0);
    }
    if (light.isSpot()) {
        frame.lightDirection = glm::vec4(glm::normalize(light.direction), 0);
        frame.lightCone = {std::cos(glm::radians(light.innerCone)), std::cos(glm::radians(light.outerCone)),
                           0, 0};
    }
    frame.waterSurface = glm::vec4(water.level - origin.y, water.ior, 0, 0);
    return frame;
}

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

} // namespace limpid
