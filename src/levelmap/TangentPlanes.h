#pragma once
#include "gl/Context.h"
#include "gl/Handles.h"
#include "gl/Program.h"
#include "levelmap/DepthPyramid.h"
#include "levelmap/LevelMap.h"
#include "levelmap/SceneDepthMap.h"

namespace limpid {

/// What exact beams read of a level map. Same size and rows as its maps.
struct TangentPlanes {
    /// RGBA32F: depth of the surface at the texel's centre, m (1e30: no receiver); how it grows by a texel
    /// right and down, m; how far aside a beam may start
    /// and its fate be certain, m (shaders/include/occlusion.glsl).
    gl::Texture planes;
    /// RGBA32F with all its levels, by blocks of texels: least and greatest depth, m; how far aside a beam
    /// may start and surely arrive at all of them, and surely at none, m.
    gl::Texture depthPyramid;
};

/// Makes them from the position and normal map.
class TangentPlanesPass {
  public:
    explicit TangentPlanesPass(gl::Context& context);
    /// `sceneDepth`: null if nothing can be before the receiver, which is number `receiverNumber` in it.
    /// `beams` are those of the map's light.
    void update(TangentPlanes& planes, const LevelMap& map, const Beams& beams, const SceneDepth* sceneDepth,
                int receiverNumber);

  private:
    gl::Context& _context;
    gl::Program _planes;
    DepthPyramidPass _pyramid;
};

} // namespace limpid
