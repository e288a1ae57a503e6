#include "apps/viewer/Projection.h"

#include <cmath>

#include "core/Optics.h"

namespace limpid::viewer {

Projection::Projection(const Camera& camera, const Water& water, const glm::dvec2& size)
    : _eye(*camera.position), _size(size),
      _focus(0.5 * size.y / std::tan(0.5 * glm::radians(camera.verticalFov))), _level(water.level),
      _ior(water.ior) {
    _back = glm::normalize(*camera.position - *camera.target);
    const glm::dvec3 across = glm::cross(glm::normalize(camera.up), _back);
    // Looking along `up`, another axis serves, the one that the picture takes too.
    _right = glm::normalize(glm::length(across) < 1e-6 ? glm::cross(glm::dvec3(0, 0, -1), _back) : across);
    _up = glm::cross(_back, _right);
}

glm::dvec3 Projection::seenAt(const glm::dvec3& point) const {
    const bool above = _eye.y >= _level;
    if ((point.y >= _level) == above) return point;
    const glm::dvec3 &upper = above ? _eye : point, &lower = above ? point : _eye;
    const glm::dvec2 away = glm::dvec2(lower.x, lower.z) - glm::dvec2(upper.x, upper.z);
    const double across = glm::length(away);
    glm::dvec2 at(upper.x, upper.z);
    if (across > 0)
        at += away / across * optics::flatCrossing(upper.y - _level, _level - lower.y, across, _ior);
    return {at.x, _level, at.y};
}

std::optional<glm::dvec2> Projection::pixel(const glm::dvec3& point) const {
    const glm::dvec3 way = seenAt(point) - _eye;
    const double ahead = -glm::dot(way, _back);
    if (ahead <= 1e-6 * (1 + glm::length(way))) return std::nullopt;
    return 0.5 * _size + _focus / ahead * glm::dvec2(glm::dot(way, _right), -glm::dot(way, _up));
}

double Projection::pixelSize(const glm::dvec3& point) const {
    const glm::dvec3 seen = seenAt(point);
    return (glm::distance(_eye, seen) + glm::distance(seen, point)) / _focus;
}

Ray Projection::ray(const glm::dvec2& pixel) const {
    const glm::dvec2 at = (pixel - 0.5 * _size) / _focus;
    return {_eye, glm::normalize(at.x * _right - at.y * _up - _back)};
}

} // namespace limpid::viewer
