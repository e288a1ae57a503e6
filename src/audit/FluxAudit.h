#pragma once
#include <span>
#include <vector>

#include "audit/BeamRays.h"
#include "audit/ShownSurface.h"
#include "engine/Engine.h"
#include "engine/Readback.h"
#include "reference/SceneGeometry.h"

namespace limpid {

/// Where what one light sends went, W, mean of R, G and B. Each is counted by itself.
struct FluxBalance {
    double entering = 0;  ///< all beams of the patch, after Fresnel
    double absorbed = 0;  ///< by the water, on the way to where beams land
    double scattered = 0; ///< likewise
    double deposited = 0; ///< Σ irradiance · surface area over the finished maps
    double missed = 0;    ///< passes every receiver
    double rejected = 0;  ///< lands where no map has a texel, or where the method takes no light
    /// The greatest of any figure that is counted by rays, and of the residual, from how much neighbouring
    /// rays differ.
    double standardError = 0;
    std::int64_t rays = 0; ///< that were followed

    double residual() const { return entering - absorbed - scattered - deposited - missed - rejected; }
};

/// Follows rays of the beams to the receivers' triangles, in double precision on the CPU, and looks up in the
/// finished maps whether a texel shows the place. It shares the beams with the methods, and no shading, no
/// plane and no sum, so that what those lose or double shows as residual.
class FluxAudit {
  public:
    /// Rays are added until their standard error is at most this share of what enters, or there are
    /// `mostRays`.
    static constexpr double wantedError = 2.5e-4;
    static constexpr int leastRays = 1 << 13, mostRays = 1 << 19;

    /// Throws std::runtime_error if Embree fails.
    FluxAudit(const Scene& scene, const glm::dvec3& origin);

    /// All but `deposited`. `light`: of the scene; `maps`: all those of this light. The same beams give the
    /// same bits.
    FluxBalance count(const BeamRays& beams, int light, std::span<const ShownSurface> maps) const;

  private:
    const Scene& _scene;
    glm::dvec3 _origin;
    reference::SceneGeometry _geometry;
};

/// The balance of every light after Engine::updateCaustics. `maps`: those of the engine, read back with
/// coverage.
std::vector<FluxBalance> auditFlux(const Engine& engine, std::span<const MapData> maps);

} // namespace limpid
