#pragma once
#include "io/bake/BakedFolder.h"
#include "reference/Reference.h"
#include "scene/Scene.h"

namespace limpid::reference {

/// What ground truth for the scene at `time` (s) is to be computed on: the very maps and the patch of water
/// that the engine takes. Needs no GPU.
TraceJob referenceJob(const Scene& scene, double time);

/// Traces the job, with progress named `what` on a terminal unless `quiet`, into the shape of a baked folder.
/// `input` is left open.
io::Bake traceBake(const TraceJob& job, TraceOptions how, const std::string& what, bool quiet);

} // namespace limpid::reference
