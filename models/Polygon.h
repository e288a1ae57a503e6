#pragma once

#include <glm/vec2.hpp>

#include <cstdint>
#include <vector>

namespace limpid::models {

/// Triangles (three indices each, counter-clockwise) of a simple polygon, counter-clockwise, by cutting off
/// ears.
std::vector<std::uint32_t> triangulated(const std::vector<glm::dvec2>& polygon);

/// Each edge moved inward by `distance`; right as long as no edge vanishes.
std::vector<glm::dvec2> inset(const std::vector<glm::dvec2>& polygon, double distance);

/// The polygon with each corner replaced by an arc of about `radius` in `steps` pieces.
std::vector<glm::dvec2> rounded(const std::vector<glm::dvec2>& polygon, double radius, int steps);

} // namespace limpid::models
