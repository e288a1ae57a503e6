#pragma once
#include <optional>

#include "gl/Context.h"
#include "gl/Handles.h"
#include "gl/Program.h"
#include "levelmap/DepthPyramid.h"
#include "levelmap/LevelMap.h"
#include "occlusion/Occluders.h"

namespace limpid {

/// What exact beams read of a level map. Same size and rows as its maps.
struct TangentPlanes {
    /// RGBA32F: depth of the surface at the texel's centre, m (1e30: no receiver); how it grows by a texel
    /// right and down, m; which places of the texel show it (shaders/caustics/rim.glsl).
    gl::Texture planes;
    /// RGBA32F with all its levels, by blocks of texels: least and greatest depth, m; -1 where one is
    /// at a rim, else 0; 0.
    gl::Texture depthPyramid;
};

/// Makes them from the position and normal map.
class TangentPlanesPass {
  public:
    explicit TangentPlanesPass(gl::Context& context);
    /// Things that may hide part of a texel: the receiver's own faces, and the water's end.
    struct Rims {
        const Occluders& occluders;
        const Beams& beams; ///< of the map's light
        int receiverNumber;
    };

    /// Without `rims`, all texels count as showing one surface each.
    void update(TangentPlanes& planes, const LevelMap& map, const Rims* rims);

  private:
    const gl::Program& programFor(const Rims* rims);

    gl::Context& _context;
    gl::Program _planes;
    std::optional<gl::Program> _planesWithRims; ///< made where there are rims
    DepthPyramidPass _pyramid;
};

} // namespace limpid
