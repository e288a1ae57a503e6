#pragma once
#include "scene/Scene.h"
#include "view/ViewFrame.h"

namespace limpid {

/// Whether a picture may show caustics on a receiver with these bounds (m from the scene's origin). They show
/// where the picture draws what is below the water: through the surface for a camera above it, straight and
/// mirrored for one below. False only if all that each of those views draws of the receiver lies beyond one
/// of its sides.
bool mayShowCaustics(const ViewFrameData& frame, const Bounds& bounds);

} // namespace limpid
