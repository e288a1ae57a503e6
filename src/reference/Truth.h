#pragma once
#include <cstdint>

#include "io/bake/BakedFolder.h"
#include "scene/Scene.h"

namespace limpid::reference {

struct TruthOptions {
    std::int64_t photons = 1'000'000; ///< for each light, >= 1
    std::uint64_t seed = 1;
    int threads = 0; ///< 0: as many as the machine has
};

/// Ground truth at `seconds`, by light tracing on the CPU, on the very texels of Caustics::maps(), as
/// io::writeBake takes it. Needs no OpenGL. The same arguments give the same bits, whatever the number of
/// threads. Throws InputError (expected, got) for photons or threads out of range and for a time that is not
/// finite. Every receiver has a mesh.
io::Bake truthOf(const Scene& scene, double seconds, const TruthOptions& options = {});

} // namespace limpid::reference
