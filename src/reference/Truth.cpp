#include "reference/Truth.h"

#include <cmath>

#include <fmt/format.h>

#include "core/Error.h"
#include "reference/ReferenceJob.h"

namespace limpid::reference {

io::Bake truthOf(const Scene& scene, double seconds, const TruthOptions& options) {
    if (options.photons < 1)
        throw InputError(fmt::format("photons: expected at least 1, got {}", options.photons));
    if (options.threads < 0)
        throw InputError(fmt::format("threads: expected at least 0, got {}", options.threads));
    if (!std::isfinite(seconds))
        throw InputError(fmt::format("seconds: expected a finite number, got {}", seconds));
    for (const Receiver& receiver : scene.receivers)
        if (!receiver.mesh)
            throw InputError(fmt::format("receiver \"{}\": expected a mesh, got none", receiver.name));
    TraceOptions how;
    how.photons = options.photons;
    how.seed = options.seed;
    how.threads = options.threads;
    return traceBake(referenceJob(scene, seconds), how, "rays", true);
}

} // namespace limpid::reference
