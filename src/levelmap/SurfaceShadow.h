#pragma once
#include <span>
#include <vector>

#include "gl/Context.h"
#include "gl/Handles.h"
#include "gl/Program.h"
#include "levelmap/ReceiverGeometry.h"
#include "water/Beams.h"
#include "water/FlatWater.h"

namespace limpid {

/// The part of the flat surface that things above it (`dry` points, in the world) may shade, as
/// LightFrameData wants it; extents 0 if there are none. No further than half a patch around the patch.
glm::vec4 surfaceShadowRect(const Light& light, const Water& water, const WaterPatch& patch,
                            std::span<const glm::dvec3> dry, const glm::dvec3& origin);

/// What stands out of the water, seen along the straight light. R32F: metres along the light from the first
/// thing it meets to the flat surface, 0 for none.
class SurfaceShadowPass {
  public:
    explicit SurfaceShadowPass(gl::Context& context);

    void draw(gl::Texture& map, const Beams& beams, std::span<const ReceiverGeometry> receivers);

  private:
    gl::Context& _context;
    gl::Program _program;
};

} // namespace limpid
