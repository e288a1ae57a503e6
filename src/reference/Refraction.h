#pragma once
#include <cmath>

#include <glm/glm.hpp>

/// Light from air (index 1) into water, in double precision. Written apart from shaders/optics/optics.glsl
/// on purpose: the reference is to find that one's mistakes.
namespace limpid::reference {

/// Unit direction below the surface: Snell's law says that the part along the surface shrinks by `ior`
/// (Born & Wolf 1.5.1). `incident` and `normal` unit, the light on the normal's side.
inline glm::dvec3 refracted(const glm::dvec3& incident, const glm::dvec3& normal, double ior) {
    const glm::dvec3 along = (incident - glm::dot(incident, normal) * normal) / ior;
    return along - std::sqrt(std::fmax(1 - glm::dot(along, along), 0.0)) * normal;
}

/// Share of unpolarised light that gets through, [0, 1] (Born & Wolf 1.5.2, eq. 20 and 21). `cosIncident` in
/// (0, 1].
inline double transmitted(double cosIncident, double ior) {
    const double sinRefracted = std::sqrt(std::fmax(1 - cosIncident * cosIncident, 0.0)) / ior;
    const double cosRefracted = std::sqrt(1 - sinRefracted * sinRefracted);
    const double across = (cosIncident - ior * cosRefracted) / (cosIncident + ior * cosRefracted);
    const double within = (ior * cosIncident - cosRefracted) / (ior * cosIncident + cosRefracted);
    return 1 - 0.5 * (across * across + within * within);
}

} // namespace limpid::reference
