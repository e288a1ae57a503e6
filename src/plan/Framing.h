#pragma once
#include "scene/Scene.h"

namespace limpid {

/// Fills in camera position and target where the scene leaves them open: above the water, looking down on the
/// smaller receivers (a receiver much larger than the rest counts as surroundings).
void frameCamera(Scene& scene);

} // namespace limpid
