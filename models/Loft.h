#pragma once

#include "Mesh.h"

namespace limpid::models {

/// One elliptical cross-section: its middle and its two half axes.
struct Section {
    glm::dvec3 centre;
    glm::dvec3 a;
    glm::dvec3 b;
};

/// How finely a loft is cut: rings for each span between sections, and corners of a ring.
struct LoftDetail {
    int ringsPerSpan = 4;
    int sides = 24;
};

/// A closed surface through the sections in their order, smooth between them (a Catmull-Rom spline). The
/// first and last sections are points (their half axes zero), where the surface rounds off. It faces outward
/// when a × b points from the first section to the last.
Shell loft(const std::vector<Section>& sections, const LoftDetail& detail);

/// The other one of a pair of fins or eyes: mirrored at z = 0, still facing outward.
Shell mirroredInZ(Shell shell);

} // namespace limpid::models
