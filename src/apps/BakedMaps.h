#pragma once
#include "engine/Engine.h"
#include "engine/Readback.h"
#include "io/bake/BakedFolder.h"

namespace limpid::apps {

/// The finished maps of the last update with their coverage, in the order of Engine::maps(). Waits for the
/// GPU.
std::vector<MapData> readAllMaps(Engine& engine);

/// The same as a baked folder has them. `maps`: of readAllMaps().
std::vector<io::BakedMap> bakedMaps(const Engine& engine, std::vector<MapData> maps);

} // namespace limpid::apps
