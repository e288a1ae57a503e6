#pragma once
#include "engine/Engine.h"
#include "io/BakedFolder.h"

namespace limpid::apps {

/// The finished maps of the last update, as a baked folder has them. Waits for the GPU.
std::vector<io::BakedMap> bakedMaps(Engine& engine);

} // namespace limpid::apps
