#pragma once
#include "gl/Context.h"
#include "gl/Handles.h"
#include "gl/Program.h"
#include "levelmap/DepthPyramid.h"
#include "levelmap/LevelMap.h"

namespace limpid {

/// What exact beams read of a level map. Same size and rows as its maps.
struct TangentPlanes {
    /// RGBA32F: depth of the surface at the texel's centre, m (1e30: no receiver); how it grows by a texel
    /// right and down, m; 0.
    gl::Texture planes;
    /// RGBA32F with all its levels, by blocks of texels: least and greatest depth, m; 0, 0.
    gl::Texture depthPyramid;
};

/// Makes them from the position and normal map.
class TangentPlanesPass {
  public:
    explicit TangentPlanesPass(gl::Context& context);
    void update(TangentPlanes& planes, const LevelMap& map);

  private:
    gl::Context& _context;
    gl::Program _planes;
    DepthPyramidPass _pyramid;
};

} // namespace limpid
