#pragma once

#include "Mesh.h"

#include <functional>

namespace limpid::models {

/// Distance to a solid, negative inside; near its surface it grows by about 1 a metre.
using Field = std::function<double(const glm::dvec3&)>;

/// The hull of two balls.
Field roundCone(const glm::dvec3& a, double radiusA, const glm::dvec3& b, double radiusB);
Field ellipsoid(const glm::dvec3& centre, const glm::dvec3& radii);

/// The union, and the first without the second; both blend over about `blend` where they meet.
Field joined(std::vector<Field> fields, double blend);
Field cut(Field from, Field what, double blend);

/// A closed surface where the field is zero, by marching tetrahedra in cubes of `cell`, then simplified to
/// about `triangles` and drawn back onto the surface. The solid lies within the box `low` to `high`.
Shell surfaceOf(const Field& field, const glm::dvec3& low, const glm::dvec3& high, double cell,
                std::size_t triangles);

} // namespace limpid::models
