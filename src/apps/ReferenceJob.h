#pragma once
#include "io/BakedFolder.h"
#include "reference/Reference.h"
#include "scene/Scene.h"

namespace limpid::apps {

/// What ground truth for the scene at `time` (s) is to be computed on: the very maps and the patch of water
/// that the engine takes. Needs no GPU.
reference::TraceJob referenceJob(const Scene& scene, double time);

/// Traces the job, with progress named `what` on a terminal unless `quiet`, into the shape of a baked folder.
/// `input` is left open.
io::Bake traceBake(const reference::TraceJob& job, reference::TraceOptions how, const std::string& what,
                   bool quiet);

} // namespace limpid::apps
