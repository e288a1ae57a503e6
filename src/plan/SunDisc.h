#pragma once
#include <vector>

#include <glm/glm.hpp>

#include "scene/Scene.h"

namespace limpid {

/// A directional light as it comes from another place of its disc: `offset` in radii of the disc from its
/// middle, beyond 1 outside of it.
Light beside(const Light& light, const glm::dvec2& offset);

/// What one of discPoints stands for: a disc of this radius about it, in radii of the light's. Wider, the
/// four run together better in deep water; narrower, penumbras and shallow water gain. Of 0.5 to 0.8, this
/// had the least sum of both errors.
inline constexpr double discPointRadius = 0.7;

/// The points of a light's disc, the middle first, among which its light is shared in equal parts: four for a
/// directional light with an angular diameter, one for any other. The middle and a triangle at
/// √(2/3 · (1 - discPointRadius²)) radii, each with its own disc about it, have the mean and the second
/// moments of the whole (R²/4 along any axis).
std::vector<Light> discPoints(const Light& light);

} // namespace limpid
