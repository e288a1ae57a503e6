#pragma once
#include "caustics/CausticMap.h"
#include "gl/Context.h"
#include "gl/Program.h"
#include "levelmap/LevelMap.h"
#include "water/Beams.h"

namespace limpid {

/// Spreads the light of a few points of a light's disc (plan/SunDisc.h) over what each of them stands for:
/// the image that this part of the disc makes through flat water, an ellipse about each texel, over
/// neighbours on the same surface. Light that falls through waves on a floor comes out right; penumbras
/// are as wide as if the water's surface cast them, but by this part of the disc only.
class DiscFilter {
  public:
    explicit DiscFilter(gl::Context& context);

    struct Inputs {
        const LevelMap& map;
        const Beams& beams; ///< of the middle of the disc
        const Light& light; ///< directional
        const Water& water;
        double farthest; ///< m of water that the light goes through to a receiver, at most
    };
    /// Leaves `caustics` alone where no texel's ellipse is a twentieth of it wide.
    void apply(CausticMap& caustics, const Inputs& inputs);
    /// Gives back its memory until the next map.
    void free() { _spread = {}; }

  private:
    gl::Context& _context;
    gl::Program _filter;
    CausticMap _spread;
};

} // namespace limpid
