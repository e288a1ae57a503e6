#pragma once
#include <vector>

#include <glm/glm.hpp>

#include "scene/Scene.h"

namespace limpid {

/// The receivers' parts on each side of the water, in the world, m. Either may be empty.
struct SideBounds {
    Bounds dry, wet;
};

enum class Side { Below, Above };

/// The corners of what lies on one side of `level`: vertices, and where edges cross it. Empty if nothing
/// does.
std::vector<glm::dvec3> pointsOfSide(const Receiver& receiver, double level, Side side);

} // namespace limpid
