#include "apps/viewer/CameraControl.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "apps/viewer/Projection.h"

namespace limpid::viewer {

namespace {

/// Right, up as the picture has it, and forward; unit.
struct Axes {
    glm::dvec3 right, up, forward;

    explicit Axes(const Camera& camera) {
        forward = glm::normalize(*camera.target - *camera.position);
        const glm::dvec3 across = glm::cross(forward, glm::normalize(camera.up));
        right =
            glm::normalize(glm::length(across) < 1e-6 ? glm::cross(forward, glm::dvec3(0, 0, -1)) : across);
        up = glm::cross(right, forward);
    }
};

double distance(const Camera& camera) {
    return glm::distance(*camera.position, *camera.target);
}

} // namespace

void orbit(Camera& camera, const glm::dvec2& angle) {
    const glm::dvec3 up = glm::normalize(camera.up);
    const Axes axes(camera);
    // Elevation over the target, which the tilt must not carry over a pole.
    const double elevation = std::asin(std::clamp(glm::dot(-axes.forward, up), -1.0, 1.0));
    const double most = glm::radians(89.0);
    const double tilt = std::clamp(elevation + angle.y, -most, most) - elevation;
    const glm::dquat turn = glm::angleAxis(-angle.x, up) * glm::angleAxis(-tilt, axes.right);
    camera.position = *camera.target + turn * (*camera.position - *camera.target);
}

void pan(Camera& camera, const glm::dvec2& shift) {
    const Axes axes(camera);
    const double height = 2 * distance(camera) * std::tan(0.5 * glm::radians(camera.verticalFov));
    const glm::dvec3 way = height * (shift.y * axes.up - shift.x * axes.right);
    *camera.position += way;
    *camera.target += way;
}

void zoom(Camera& camera, double factor) {
    // Closer than this, single precision has nothing left to show.
    constexpr double least = 1e-4, most = 1e6;
    const double to = std::clamp(factor * distance(camera), least, most);
    camera.position = *camera.target - to * Axes(camera).forward;
}

void fly(Camera& camera, const glm::dvec3& way) {
    const Axes axes(camera);
    const glm::dvec3 move =
        distance(camera) * (way.x * axes.right + way.y * glm::normalize(camera.up) + way.z * axes.forward);
    *camera.position += move;
    *camera.target += move;
}

void frame(Camera& camera, const Bounds& bounds, const Water& water) {
    if (bounds.empty()) return;
    const glm::dvec3 back = -Axes(camera).forward;
    const double radius = std::max(0.5 * glm::length(bounds.size()), 1e-6);
    camera.position =
        bounds.center() + back * (1.1 * radius / std::sin(0.5 * glm::radians(camera.verticalFov)));
    camera.target = bounds.center();
    const glm::dvec3 seen = Projection(camera, water, {1, 1}).seenAt(bounds.center());
    if (glm::distance(seen, *camera.position) > 1e-3 * radius) camera.target = seen;
}

} // namespace limpid::viewer
