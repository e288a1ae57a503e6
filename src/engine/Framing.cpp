#include "engine/Framing.h"

#include <algorithm>
#include <cmath>

namespace limpid {

namespace {

double extentOf(const Bounds& bounds) {
    const glm::dvec3 s = bounds.size();
    return std::max({s.x, s.y, s.z});
}

/// What the picture is about: everything but receivers three times larger than the smallest.
Bounds subject(const Scene& scene) {
    double smallest = 1e300;
    for (const Receiver& r : scene.receivers) smallest = std::min(smallest, extentOf(worldBounds(r)));
    Bounds bounds;
    for (const Receiver& r : scene.receivers) {
        const Bounds own = worldBounds(r);
        if (extentOf(own) <= 3 * smallest) bounds.add(own.min), bounds.add(own.max);
    }
    return bounds;
}

} // namespace

void frameCamera(Scene& scene) {
    Camera& camera = scene.camera;
    if (camera.position && camera.target) return;
    const Bounds bounds = subject(scene);
    if (bounds.empty()) {
        camera.position = camera.position.value_or(glm::dvec3(0, scene.water.level + 1, 2));
        camera.target = camera.target.value_or(glm::dvec3(0, scene.water.level, 0));
        return;
    }
    const double size = std::max(glm::length(bounds.size()), 1e-6);
    camera.target = camera.target.value_or(bounds.center());
    if (camera.position) return;
    const double distance = 0.72 * size / std::tan(0.5 * glm::radians(camera.verticalFov));
    glm::dvec3 position = *camera.target + distance * glm::normalize(glm::dvec3(0.25, 0.95, 0.8));
    position.y = std::max(position.y, scene.water.level + 0.35 * size);
    camera.position = position;
}

} // namespace limpid
