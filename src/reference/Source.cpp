#include "reference/Source.h"

#include <algorithm>
#include <cmath>

namespace limpid::reference {

double Source::withinCone(const glm::dvec3& incident) const {
    const double share = (glm::dot(incident, direction) - cosOuter) / std::max(0.001, cosInner - cosOuter);
    return std::pow(std::clamp(share, 0.0, 1.0), 2);
}

double Source::through(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) const {
    const glm::dvec3 across = glm::cross(b - a, c - a);
    if (!point) return -0.5 * weight * glm::dot(across, direction);
    // Van Oosterom and Strackee 1983; the triple product from edges keeps its digits for small triangles.
    const glm::dvec3 p = a - position, q = b - position, r = c - position;
    const double lp = glm::length(p), lq = glm::length(q), lr = glm::length(r);
    const double triple = -glm::dot(p, across);
    const double below = lp * lq * lr + glm::dot(p, q) * lr + glm::dot(q, r) * lp + glm::dot(r, p) * lq;
    return triple == 0 ? 0 : 2 * std::atan2(triple, below);
}

double Source::density(const glm::dvec3& place, const glm::dvec2& slope) const {
    const glm::dvec3 up(-slope.x, 1, -slope.y);
    if (!point) return -weight * glm::dot(up, direction);
    const glm::dvec3 way = place - position;
    const double distance = glm::length(way);
    return -glm::dot(up, way) / (distance * distance * distance);
}

Source sourceOf(const Light& light, const glm::dvec3& origin, const glm::dvec2& disc) {
    Source source;
    source.point = light.type == LightType::Point;
    source.position = light.position - origin;
    source.strength = source.point ? light.intensity : light.irradiance;
    if (light.isSpot()) {
        source.direction = glm::normalize(light.direction);
        source.cosInner = std::cos(glm::radians(light.innerCone));
        source.cosOuter = std::cos(glm::radians(light.outerCone));
    }
    if (source.point) return source;
    const glm::dvec3 middle = glm::normalize(light.direction);
    const glm::dvec3 helper = std::abs(middle.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 0, 1);
    const glm::dvec3 right = glm::normalize(glm::cross(helper, middle)), down = glm::cross(middle, right);
    const glm::dvec2 aside = std::sin(0.5 * glm::radians(light.angularDiameter)) * disc;
    const double along = std::sqrt(1 - glm::dot(aside, aside));
    source.direction = along * middle + aside.x * right + aside.y * down;
    source.weight = 1 / along;
    return source;
}

Shade::Shade(const SceneGeometry& geometry, const Surface& surface, double level, const glm::dvec2& patchMin,
             const glm::dvec2& patchMax)
    : _geometry(geometry), _surface(surface), _level(level), _patchMin(patchMin), _patchMax(patchMax),
      _emergent(geometry.top() > level - surface.highest()) {}

glm::dvec3 Shade::lit(const Source& source, const glm::dvec3& place) const {
    const glm::dvec3 up = -source.incident(place);
    if (up.y <= 0) return glm::dvec3(0); // the part of a disc that has set
    const double distance = source.point ? glm::distance(place, source.position) : 1e30;
    const glm::dvec3 share = _emergent ? _geometry.through(place, up, distance) : glm::dvec3(1);
    return share != glm::dvec3(0) && behindCrest(place, up, distance) ? glm::dvec3(0) : share;
}

bool Shade::behindCrest(const glm::dvec3& place, const glm::dvec3& up, double distance) const {
    const double run = std::hypot(up.x, up.z);
    // A ray that rises faster than the surface can never meets it again.
    const double closing = run * _surface.steepest() - up.y;
    if (closing <= 0) return false;
    double end = std::min(distance, (_level + _surface.highest() - place.y) / up.y);
    for (int c = 0; c < 2; ++c) { // beyond the patch the surface is flat
        const double way = up[2 * c], from = place[2 * c];
        if (way != 0) end = std::min(end, ((way > 0 ? _patchMax[c] : _patchMin[c]) - from) / way);
    }
    const double least = _surface.shortest() / 48 / run;
    for (double s = least; s < end;) {
        const glm::dvec3 at = place + s * up;
        const double over = at.y - _level - _surface.at({at.x, at.z}).height;
        if (over < 0) return true;
        s += std::max(over / closing, least);
    }
    return false;
}

} // namespace limpid::reference
