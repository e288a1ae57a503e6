#pragma once
#include "scene/Mesh.h"

/// Built-in receivers, centred on the origin of their own space, sizes in metres, with one material of the
/// given albedo.
namespace limpid {

/// Rectangle in xz, facing up. `size` > 0 along x and z.
Mesh makePlane(glm::dvec2 size, glm::vec3 albedo);

/// `segments` slices of as many stacks, >= 4, one triangle less in each slice at either pole: with 32 that
/// is 32 · 2 · (32 − 1) = 1,984 triangles, as the thesis's sphere has. `radius` > 0.
Mesh makeSphere(double radius, glm::vec3 albedo, int segments = 32);

/// 12 triangles. `size` > 0 along x, y and z.
Mesh makeBox(glm::dvec3 size, glm::vec3 albedo);

} // namespace limpid
