#pragma once
#include "scene/Scene.h"

namespace limpid {

/// The scene's camera, with position and target where the scene leaves them open: above the water, looking
/// down on the smaller receivers (a receiver much larger than the rest counts as surroundings).
Camera framedCamera(const Scene& scene);

} // namespace limpid
