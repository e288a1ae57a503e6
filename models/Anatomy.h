#pragma once

#include "Loft.h"

namespace limpid::models {

/// Parts of animals that swim along +x with y up. Each is a closed shell; parts overlap where they join.

/// A cross-section of the body: an ellipse between `top` and `bottom`, `halfWidth` to either side.
struct BodyRow {
    double x, top, bottom, halfWidth;
};

/// The trunk through its rows from nose to tail; the first and last close it to a point.
Shell body(const std::vector<BodyRow>& rows, const LoftDetail& detail = {.ringsPerSpan = 3, .sides = 22});

/// A cut through a fin from its leading to its trailing edge, lens-shaped.
struct FinRow {
    glm::dvec3 front, back;
    double halfThickness;
};

/// A fin through its rows from root to tip, or tip to tip; the first and last close it to a point.
Shell fin(const std::vector<FinRow>& rows);

/// A ball, an eye for instance.
Shell ball(const glm::dvec3& centre, double radius);

} // namespace limpid::models
