#pragma once
#include <span>
#include <vector>

#include "gl/Context.h"
#include "gl/Handles.h"
#include "gl/Program.h"
#include "levelmap/ReceiverGeometry.h"
#include "plan/FlatWater.h"
#include "water/Beams.h"

namespace limpid {

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
