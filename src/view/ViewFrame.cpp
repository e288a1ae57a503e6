#include "view/ViewFrame.h"

#include <algorithm>
#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

#include "core/Optics.h"
#include "water/WaveTerms.h"

namespace limpid {

namespace {

/// Nothing nearer than this is seen, m: a thousandth of the way to what the picture is about.
double nearPlane(const Bounds& bounds, const Camera& camera) {
    const double toScene =
        bounds.empty() ? 1e300
                       : glm::distance(*camera.position, bounds.center()) + glm::length(bounds.size());
    return 1e-3 * std::max(std::min(glm::distance(*camera.position, *camera.target), toScene), 1e-9);
}

/// An upper bound on metres beyond the surface between the camera's rays and any receiver. Waves bend rays
/// further than flat water does; a quarter more has room for it.
double farthestSeen(const Bounds& bounds, const Water& water, const glm::dvec3& camera) {
    double farthest = 1e-6;
    for (int i = 0; i < 8; ++i) {
        const glm::dvec3 corner(i & 1 ? bounds.max.x : bounds.min.x, i & 2 ? bounds.max.y : bounds.min.y,
                                i & 4 ? bounds.max.z : bounds.min.z);
        const double above = camera.y - water.level, below = std::max(water.level - corner.y, 0.0);
        const double across = glm::distance(glm::dvec2(camera.x, camera.z), glm::dvec2(corner.x, corner.z));
        const double rest =
            above > 0 ? across - optics::flatCrossing(above, below, across, water.ior) : across;
        farthest = std::max(farthest, above > 0 ? std::hypot(rest, below) : glm::distance(corner, camera));
    }
    return 1.25 * farthest;
}

/// Radiance of endless water in which the ambient light is the same everywhere: what each metre scatters into
/// a ray balances what extinction takes from it.
glm::dvec3 deepRadiance(const Scene& scene) {
    glm::dvec3 deep = scene.ambientRadiance;
    for (int c = 0; c < 3; ++c) {
        const double lost = scene.water.absorption[c] + scene.water.scattering[c];
        if (lost > 0) deep[c] *= scene.water.scattering[c] / lost;
    }
    return deep;
}

glm::dmat4 viewProjection(const Camera& camera, const glm::dvec3& origin, double near, glm::ivec2 size) {
    const glm::dvec3 position = *camera.position - origin, target = *camera.target - origin;
    const glm::dmat4 projection =
        glm::infinitePerspective(glm::radians(camera.verticalFov), double(size.x) / double(size.y), near);
    const glm::dvec3 forward = glm::normalize(target - position);
    // Looking along `up`, any other axis serves.
    const bool vertical = glm::length(glm::cross(forward, glm::normalize(camera.up))) < 1e-6;
    return projection * glm::lookAt(position, target, vertical ? glm::dvec3(0, 0, -1) : camera.up);
}

void setBounds(glm::vec4& min, glm::vec4& max, const Bounds& bounds, const glm::dvec3& origin) {
    if (bounds.empty()) {
        min = max = glm::vec4(0);
        return;
    }
    // A ray is followed to the end of the box, which must not lie in the faces that it is to meet.
    const double margin = 0.01 * std::max(glm::length(bounds.size()), 1e-6);
    min = glm::vec4(bounds.min - margin - origin, 1);
    max = glm::vec4(bounds.max + margin - origin, 0);
}

/// Both sides reach as far as waves lay them bare or cover them.
void setSides(ViewFrameData& frame, SideBounds sides, const Water& water, const glm::dvec3& origin) {
    sides.dry.min.y = std::min(sides.dry.min.y, water.level - highestWave(water));
    sides.wet.max.y = std::max(sides.wet.max.y, water.level + highestWave(water));
    const bool above = frame.cameraAbove();
    setBounds(frame.nearSideMin, frame.nearSideMax, above ? sides.dry : sides.wet, origin);
    setBounds(frame.farSideMin, frame.farSideMax, above ? sides.wet : sides.dry, origin);
}

} // namespace

ViewFrameData viewFrame(const Scene& scene, const glm::dvec3& origin, const WaterPatch& patch,
                        const SideBounds& sides, glm::ivec2 samples) {
    const Camera& camera = scene.camera;
    const Water& water = scene.water;
    const Bounds bounds = worldBounds(scene);
    ViewFrameData frame;
    frame.viewProjection = viewProjection(camera, origin, nearPlane(bounds, camera), samples);
    frame.cameraPosition = glm::vec4(*camera.position - origin, camera.position->y > water.level ? 1 : 0);
    frame.ambientRadiance = glm::vec4(scene.ambientRadiance, 0);
    frame.skyRadiance = glm::vec4(scene.skyRadiance, 0);
    frame.waterExtinction =
        glm::vec4(water.absorption + water.scattering, farthestSeen(bounds, water, *camera.position));
    const double texel = 2 * std::tan(0.5 * glm::radians(camera.verticalFov)) / samples.y;
    frame.viewWater = glm::vec4(water.level - origin.y, water.ior, 1 / (1 + viewMargin), texel);
    frame.deepRadiance = glm::vec4(deepRadiance(scene), 0);
    frame.patchRect = glm::vec4(patch.min() - glm::dvec2(origin.x, origin.z), patch.size);
    frame.patchQuads = glm::ivec4(patch.grid, 0, 0);
    setSides(frame, sides, water, origin);
    return frame;
}

} // namespace limpid
