#include "apps/viewer/Pick.h"

#include <cmath>
#include <limits>

namespace limpid::viewer {

namespace {

/// How far along the ray it meets the triangle, in lengths of its direction (Möller and Trumbore 1997).
std::optional<double> meets(const Ray& ray, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    const glm::dvec3 ab = b - a, ac = c - a;
    const glm::dvec3 p = glm::cross(ray.direction, ac);
    const double volume = glm::dot(ab, p);
    if (volume == 0) return std::nullopt;
    const glm::dvec3 from = ray.origin - a;
    const double u = glm::dot(from, p) / volume;
    const glm::dvec3 q = glm::cross(from, ab);
    const double v = glm::dot(ray.direction, q) / volume;
    const double t = glm::dot(ac, q) / volume;
    if (u < 0 || v < 0 || u + v > 1 || t <= 0) return std::nullopt;
    return t;
}

/// The ray in the receiver's own space; distances along it stay what they are.
Ray toLocal(const Receiver& receiver, const Ray& ray) {
    const glm::dquat back = glm::conjugate(receiver.rotation);
    return {back * (ray.origin - receiver.translation) / receiver.scale,
            back * ray.direction / receiver.scale};
}

double firstOf(const Receiver& receiver, const Ray& world, double farthest) {
    const Mesh& mesh = *receiver.mesh;
    const Ray ray = toLocal(receiver, world);
    double first = farthest;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const auto t = meets(ray, mesh.positions[mesh.indices[i]], mesh.positions[mesh.indices[i + 1]],
                             mesh.positions[mesh.indices[i + 2]]);
        if (t && *t < first) first = *t;
    }
    return first;
}

/// What becomes of a view ray at the flat surface, from either side.
Ray beyond(const Ray& ray, double t, double ior) {
    const glm::dvec3 normal(0, ray.direction.y < 0 ? 1 : -1, 0);
    const double ratio = ray.direction.y < 0 ? 1 / ior : ior;
    const double cosine = -glm::dot(normal, ray.direction);
    const double k = 1 - ratio * ratio * (1 - cosine * cosine);
    const glm::dvec3 point = ray.origin + t * ray.direction;
    if (k < 0) return {point, ray.direction + 2 * cosine * normal};
    return {point, glm::normalize(ratio * ray.direction + (ratio * cosine - std::sqrt(k)) * normal)};
}

} // namespace

std::optional<Hit> firstAlong(const Scene& scene, const Ray& ray, double farthest) {
    std::optional<Hit> hit;
    for (std::size_t i = 0; i < scene.receivers.size(); ++i) {
        const double t = firstOf(scene.receivers[i], ray, farthest);
        if (t >= farthest) continue;
        farthest = t;
        hit = {int(i), ray.origin + t * ray.direction};
    }
    return hit;
}

std::optional<Hit> pick(const Scene& scene, const Ray& ray) {
    constexpr double endless = std::numeric_limits<double>::infinity();
    const double toSurface = (scene.water.level - ray.origin.y) / ray.direction.y;
    const bool crosses = std::isfinite(toSurface) && toSurface > 0;
    if (const auto hit = firstAlong(scene, ray, crosses ? toSurface : endless)) return hit;
    if (!crosses) return std::nullopt;
    return firstAlong(scene, beyond(ray, toSurface, scene.water.ior), endless);
}

} // namespace limpid::viewer
