#pragma once
#include <span>

#include "gl/Context.h"
#include "gl/Handles.h"
#include "gl/Program.h"
#include "levelmap/ReceiverGeometry.h"
#include "water/Beams.h"

namespace limpid {

/// First hits of a point light under water, in all directions (shaders/levelmap/point_light_shadow.glsl).
/// R32F: metres from the point light to the first receiver below the level, 1e30 for none.
class PointLightShadowPass {
  public:
    explicit PointLightShadowPass(gl::Context& context);

    /// `beams.frame` says where the point light is.
    void draw(gl::Texture& map, const Beams& beams, std::span<const ReceiverGeometry> receivers);

  private:
    gl::Context& _context;
    gl::Program _program;
};

} // namespace limpid
