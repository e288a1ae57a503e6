#include "plan/Framing.h"

#include <algorithm>
#include <cmath>

#include "core/Optics.h"

namespace limpid {

namespace {

double extentOf(const Bounds& bounds) {
    const glm::dvec3 s = bounds.size();
    return std::max({s.x, s.y, s.z});
}

/// What the picture is about: everything but receivers three times larger than the smallest.
Bounds subject(const Scene& scene) {
    double smallest = 1e300;
    for (const Receiver& r : scene.receivers)
        smallest = std::min(smallest, extentOf(worldBounds(r)));
    Bounds bounds;
    for (const Receiver& r : scene.receivers) {
        const Bounds own = worldBounds(r);
        if (extentOf(own) <= 3 * smallest) bounds.add(own.min), bounds.add(own.max);
    }
    return bounds;
}

/// Where to look for `point` to be in the middle of the picture: under water it seems to be higher than it
/// is.
glm::dvec3 seenAt(const glm::dvec3& camera, const glm::dvec3& point, const Water& water) {
    if (camera.y <= water.level || point.y >= water.level) return point;
    const glm::dvec2 away = glm::dvec2(point.x, point.z) - glm::dvec2(camera.x, camera.z);
    const double across = glm::length(away);
    if (across <= 0) return point;
    const double x = optics::flatCrossing(camera.y - water.level, water.level - point.y, across, water.ior);
    const glm::dvec2 at = glm::dvec2(camera.x, camera.z) + away * (x / across);
    return {at.x, water.level, at.y};
}

} // namespace

Camera framedCamera(const Scene& scene) {
    Camera camera = scene.camera;
    if (camera.position && camera.target) return camera;
    const Bounds bounds = subject(scene);
    const double level = scene.water.level;
    if (bounds.empty()) {
        camera.position = camera.position.value_or(glm::dvec3(0, level + 1, 2));
        camera.target = camera.target.value_or(glm::dvec3(0, level, 0));
        return camera;
    }
    const double size = std::max(glm::length(bounds.size()), 1e-6);
    const glm::dvec3 center = bounds.center();
    if (!camera.position) {
        const double distance = 0.62 * size / std::tan(0.5 * glm::radians(camera.verticalFov));
        glm::dvec3 position =
            camera.target.value_or(center) + distance * glm::normalize(glm::dvec3(0.3, 1.1, 0.75));
        position.y = std::max(position.y, level + 0.35 * size);
        camera.position = position;
    }
    if (!camera.target) camera.target = seenAt(*camera.position, center, scene.water);
    return camera;
}

} // namespace limpid
