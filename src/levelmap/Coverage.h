#pragma once
#include "gl/Context.h"
#include "gl/Handles.h"
#include "gl/Program.h"
#include "levelmap/LevelMap.h"

namespace limpid {

/// How much of each texel is covered by the surface at its middle, which is the one that the texel holds
/// light of: what a map sums by whole texels is there by parts of them at rims and creases. For counting
/// light after a frame; no frame needs it.
class CoveragePass {
  public:
    explicit CoveragePass(gl::Context& context);

    /// R32F, size and rows of the map: the share of the texel's area where the map sees the face at its
    /// middle or one that goes on from it, (0, 1]; 0 where there is no receiver. Told by places on a grid
    /// that leans against the texels, 3 to 16 along a texel's side, fewer in maps of more than 1260.
    gl::Texture draw(const LevelMap& map, const ReceiverGeometry& geometry, const Beams& beams);

  private:
    void drawPlaces(const gl::Texture& covered, const ReceiverGeometry& geometry);

    gl::Context& _context;
    gl::Program _draw, _share;
};

} // namespace limpid
