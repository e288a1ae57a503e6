#pragma once
#include "gl/Context.h"
#include "gl/Handles.h"
#include "gl/Program.h"
#include "levelmap/DepthPyramid.h"
#include "levelmap/LevelMap.h"

namespace limpid {

/// The planes of a level map's texels, for beams that look for the ones they can meet. RGBA32F with all
/// levels, same size and rows as the maps: least and greatest depth, m, of the planes that texels with light
/// belong to; 1e30, -1e30 where there is none. In the finest level both are the texel's own.
struct PlaneDepths {
    gl::Texture pyramid;
};

/// Makes them from a position map whose texels have their planes.
class PlaneDepthsPass {
  public:
    explicit PlaneDepthsPass(gl::Context& context);
    void update(PlaneDepths& depths, const LevelMap& map);

  private:
    gl::Context& _context;
    gl::Program _program;
    DepthPyramidPass _pyramid;
};

} // namespace limpid
