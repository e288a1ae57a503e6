#pragma once
#include <glm/glm.hpp>

#include "scene/Scene.h"

/// How mouse and keys move a camera that has position and target.
namespace limpid::viewer {

/// Around the target, by angles in radians: as if the scene were turned to the right and tilted towards the
/// viewer. Stays a degree away from the poles.
void orbit(Camera& camera, const glm::dvec2& angle);

/// Sideways, so that what is at the target's distance moves by `shift` (right, down) as a share of the
/// picture's height.
void pan(Camera& camera, const glm::dvec2& shift);

/// Closer to the target, to `factor` > 0 of the distance.
void zoom(Camera& camera, double factor);

/// Camera and target together: right, up (along the camera's own `up`), forward; in distances to the target.
void fly(Camera& camera, const glm::dvec3& way);

/// Looks at the middle of `bounds` from where it looks now, so near that all of it just shows, refracted by
/// `water` if it must be. Empty bounds leave the camera as it is.
void frame(Camera& camera, const Bounds& bounds, const Water& water);

} // namespace limpid::viewer
