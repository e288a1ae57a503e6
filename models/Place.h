#pragma once

#include "Mesh.h"

#include <functional>

namespace limpid::models {

/// Colour (albedo, linear RGB) from sRGB as it is written in pictures: 0xRRGGBB.
glm::dvec3 rgb(unsigned hex);

/// Colour by position.
using Paint = std::function<glm::dvec3(const glm::dvec3&)>;
Shell painted(Shell shell, const Paint& paint);
Shell painted(Shell shell, unsigned hex);

Shell moved(Shell shell, const glm::dvec3& offset);
Shell scaled(Shell shell, const glm::dvec3& factors);

/// Turned around an axis of the frame (0, 1, 2: x, y, z) by degrees, counter-clockwise seen from its tip.
Shell turned(Shell shell, int axis, double degrees);

/// Every position through `f`, which must not turn the shell inside out.
Shell shaped(Shell shell, const std::function<glm::dvec3(const glm::dvec3&)>& f);

/// Every position moved along the normal by `amount` there.
Shell swollen(Shell shell, const std::function<double(const glm::dvec3&)>& amount);

/// 0 before `from`, 1 beyond `to`, smooth between; `to` may be the lower one.
double ramp(double from, double to, double x);

/// 1 at `centre`, 0 farther than `width` from it, smooth between.
double bump(double centre, double width, double x);

/// Even noise in [0, 1], smooth over about `size`; the same on every machine.
double noise(const glm::dvec3& p, double size);

/// Distance to the nearest of scattered points, one in each cell of `size`, in cells: spots where it is
/// small.
double scatter(const glm::dvec3& p, double size);

/// The same on a flank: points scattered over x and y, others on either side of z = 0.
double flankScatter(const glm::dvec3& p, double size);

} // namespace limpid::models
