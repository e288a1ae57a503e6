#pragma once
#include <optional>
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
    explicit SurfaceShadowPass(gl::Context& context) : _context(context) {}

    void draw(gl::Texture& map, const Beams& beams, std::span<const ReceiverGeometry> receivers);

  private:
    gl::Context& _context;
    std::optional<gl::Program> _program; ///< made for the first map
};

} // namespace limpid
