#pragma once
#include <cstdint>
#include <functional>
#include <vector>

#include <glm/glm.hpp>

#include "reference/TexelMap.h"
#include "scene/Scene.h"

/// Ground truth: caustics by light tracing, in double precision, on the texels that a bake has.
namespace limpid::reference {

struct TraceJob {
    Scene scene;
    double time = 0;      ///< s
    glm::dvec3 origin{0}; ///< what positions in the result are relative to, m in the world
    glm::dvec2 patchMin{0},
        patchSize{1}; ///< the rectangle of the surface that light is followed from: x, z, m, in the world
    std::vector<bool> lightEnters; ///< of each light: whether it makes caustics at all
    std::vector<MapRequest> maps;
};

struct TraceOptions {
    std::int64_t photons = 0; ///< for each light, >= 1; a photon is a cell of the surface with its footprint
    std::uint64_t seed = 1;
    int threads = 0;                                   ///< 0: as many as the machine has
    std::function<void(int done, int total)> progress; ///< called now and then from the calling thread
};

struct TracedLight {
    /// W, mean of R, G and B; see io/bake/BakedFolder.h. Each is counted by itself.
    double entering = 0, absorbed = 0, scattered = 0, deposited = 0, missed = 0, rejected = 0;
    std::int64_t photons = 0; ///< that were followed

    double residual() const { return entering - absorbed - scattered - deposited - missed - rejected; }
};

struct TraceResult {
    std::vector<TexelMap::Finished> maps; ///< in the order of the job's
    std::vector<TracedLight> lights;
};

/// The maps are made of this many independent estimates, from whose spread the standard error follows: the
/// nMAE (mean absolute error over the mean) that a perfect map would show against this one, if every texel's
/// error were normal. What all estimates have in common, by the size of their cells, it does not know:
/// against maps of 16 times the photons, those of teapot, fish and floor were off by 1.1 to 1.4 times as
/// much.
inline constexpr int batches = 8;

/// The same job with the same photons and seed gives the same bits, whatever the number of threads.
TraceResult traceLight(const TraceJob& job, const TraceOptions& options);

} // namespace limpid::reference
