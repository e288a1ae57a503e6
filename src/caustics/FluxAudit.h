#pragma once
#include <span>

#include "gl/Context.h"
#include "gl/Program.h"
#include "levelmap/LevelMap.h"
#include "levelmap/SceneDepthMap.h"
#include "water/Beams.h"

namespace limpid {

/// Where the light of one lamp went, W, mean of R, G and B. Each is counted by itself.
struct FluxBalance {
    double entering = 0;  ///< all beams of the patch, after Fresnel
    double absorbed = 0;  ///< by the water, on the way to where beams land
    double scattered = 0; ///< likewise
    double deposited = 0; ///< Σ irradiance · surface area over the finished maps
    double missed = 0;    ///< passes every receiver
    double rejected = 0;  ///< lands where no map has a texel, or where the method takes no light

    double residual() const { return entering - absorbed - scattered - deposited - missed - rejected; }
};

/// Follows a few rays of every beam to where they land. It shares the beams with the methods, and is given a
/// scene depth map of its own, but no plane and no texel sum, so that what those lose or double shows as
/// residual.
class FluxAudit {
  public:
    explicit FluxAudit(gl::Context& context);

    struct Placed {
        int receiver;
        const LevelMap* map;
        const gl::Texture* coverage; ///< of the map (levelmap/Coverage.h)
    };
    /// What a method shades by: the mean light, or each beam's own direction.
    enum class Shade { Mean, Own };
    /// All but `deposited`. `sceneDepth` covers every receiver; `maps` are all those of this light.
    /// `farthest` as for SceneDepthPass. Waits for the GPU.
    FluxBalance count(const Beams& beams, const WaterMesh& surface, const Water& water,
                      const SceneDepth& sceneDepth, std::span<const Placed> maps, double farthest,
                      Shade shade);

  private:
    void follow(const gl::Program& program, int firstTriangle, int beamCount, double farthest);
    void place(int firstTriangle, int beamCount, int receiverNumber);
    gl::Context& _context;
    gl::Program _land, _landOwn, _meet, _place;
};

/// Σ irradiance · surface area in the texel, W, mean of R, G and B. `irradiance`: RGB, `normalDotAxis`: |n·V|
/// of each texel, 0 where there is no receiver; `coverage`: the share of each that the receiver covers.
double depositedFlux(std::span<const float> irradiance, std::span<const float> normalDotAxis,
                     std::span<const float> coverage, double texelArea);

} // namespace limpid
