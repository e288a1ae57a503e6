#pragma once
#include "reference/Reference.h"
#include "scene/Scene.h"

namespace limpid::apps {

/// What ground truth for the scene at `time` (s) is to be computed on: the very maps and the patch of water
/// that the engine takes. Needs no GPU.
reference::TraceJob referenceJob(const Scene& scene, double time);

} // namespace limpid::apps
