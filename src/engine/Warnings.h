#pragma once
#include <string>
#include <vector>

#include "scene/Scene.h"
#include "water/FlatWater.h"

namespace limpid {

/// What a scene asks for that will not come out as its author may think, one line each: waves too short for
/// the grid or so steep that beams cross the surface again, lights that do not enter the water, receivers
/// that are dry.
std::vector<std::string> sceneWarnings(const Scene& scene, const WaterPatch& patch);

} // namespace limpid
