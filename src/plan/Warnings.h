#pragma once
#include <string>
#include <vector>

#include "plan/FlatWater.h"
#include "scene/Scene.h"

namespace limpid {

/// Lines for what will not come out as a scene's author may think: parts of models that are not used, or that
/// are water themselves; waves too short for the grid or the maps, stepped, or so steep that beams cross the
/// surface again; lights that do not enter the water; receivers that are dry.
std::vector<std::string> sceneWarnings(const Scene& scene, const WaterPatch& patch);

} // namespace limpid
