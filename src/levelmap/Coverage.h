#pragma once
#include "gl/Context.h"
#include "gl/Handles.h"
#include "gl/Program.h"
#include "levelmap/LevelMap.h"

namespace limpid {

/// How much of each texel its receiver covers: what a map sums at a rim by whole texels is there by parts of
/// them. For counting light after a frame; no frame needs it.
class CoveragePass {
  public:
    explicit CoveragePass(gl::Context& context);

    /// R32F, size and rows of the map: the share of the texel's area where there is surface that the map
    /// holds, [0, 1]. Told by places on a grid, 7 by 7 of a texel, and fewer where that would be more than
    /// 4096 across the map; the texel's middle, which says whether the map has a texel, is always one.
    gl::Texture draw(const LevelMap& map, const ReceiverGeometry& geometry, const Beams& beams);

  private:
    gl::Context& _context;
    gl::Program _draw, _mean;
};

} // namespace limpid
