#pragma once

#include "Mesh.h"
#include "Polygon.h"

#include <glm/vec2.hpp>

#include <functional>

namespace limpid::models {

/// Closed shells that face outward, in metres of the recipe that asks for them.

/// A smooth curve (Catmull-Rom) through points that share [0, 1] evenly.
glm::dvec3 along(const std::vector<glm::dvec3>& points, double t);

/// `outline` (x: distance from the axis, y: height) turned around the y axis, in its order from bottom to top
/// with the inside to its left. It begins and ends on the axis (x = 0), or else its end joins its beginning,
/// which gives a ring. Corners of the outline stay corners.
Shell lathe(const std::vector<glm::dvec2>& outline, int sides);

/// The same outline through a Catmull-Rom spline, `steps` pieces for each of its own; it begins and ends on
/// the axis.
Shell smoothLathe(const std::vector<glm::dvec2>& outline, int steps, int sides);

/// A ball whose poles lie on z, which suits eyes: `rows` from pole to pole.
Shell globe(const glm::dvec3& centre, double radius, int rows, int sides);

/// A round rod along a smooth curve through the points, with a radius at each; the ends are flat.
Shell rod(const std::vector<glm::dvec3>& points, const std::vector<double>& radii, int steps, int sides);

/// A simple polygon (counter-clockwise, any shape without holes) as a slab from z0 to z1; its rims are cut
/// back by `bevel`, which must be less than half of its narrowest part.
Shell slab(const std::vector<glm::dvec2>& polygon, double z0, double z1, double bevel = 0.0);

/// A box given by two opposite corners: 12 triangles, or 44 with a bevel.
Shell block(const glm::dvec3& low, const glm::dvec3& high, double bevel = 0.0);

/// A box with round edges: |x/a|^p + |y/b|^p + |z/c|^p = 1 for the half extents (a, b, c); 12 · steps²
/// triangles. p = 2 is an ellipsoid, 4 a cushion, 10 a box.
Shell cushion(const glm::dvec3& centre, const glm::dvec3& half, double power, int steps);

/// A thin sheet over (u, v) ∈ [0, 1]²: its middle, its half thickness inside (it is sharp at its rim) and its
/// colour; 4 · nu · nv triangles.
struct Sheet {
    std::function<glm::dvec3(double u, double v)> middle;
    std::function<double(double u, double v)> half;
    std::function<glm::dvec3(double u, double v)> colour;
    int nu = 6, nv = 12;
};
Shell sheet(const Sheet& sheet);

} // namespace limpid::models
