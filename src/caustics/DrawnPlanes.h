#pragma once
#include "caustics/CausticMap.h"
#include "caustics/PlaneDrawer.h"
#include "levelmap/LevelMap.h"

namespace limpid {

/// The thesis's method, as drawn there (figure 4-15): for each reference plane, the intersection triangles of
/// all beams are rasterised with additive blending, and a texel takes those of its own plane. Sampling is at
/// texel centres. Both `level-map` and `level-map-smart`: they differ in the planes that the level map lists.
class DrawnPlanes {
  public:
    explicit DrawnPlanes(gl::Context& context);

    /// Clears and fills `caustics`. `beams` are those of the level map's light.
    void fill(CausticMap& caustics, const LevelMap& map, const Beams& beams, const WaterMesh& surface,
              const Water& water);
    /// Gives back its memory until the next fill.
    void free() { _drawer.free(); }

  private:
    gl::Context& _context;
    PlaneDrawer _drawer;
};

} // namespace limpid
