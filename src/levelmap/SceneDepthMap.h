#pragma once
#include <optional>
#include <span>

#include "gl/Context.h"
#include "gl/Handles.h"
#include "gl/Program.h"
#include "levelmap/ReceiverGeometry.h"
#include "water/Beams.h"

namespace limpid {

/// The part of the flat surface where the mean light enters that reaches any of `points` (submerged, in the
/// world), as LightFrameData wants it: x, z of a corner and extents, m from the scene's origin. A margin
/// keeps the outermost points inside.
glm::vec4 sceneDepthRect(const Light& light, const Water& water, std::span<const glm::dvec3> points,
                         const glm::dvec3& origin);

/// What one light hits first. RG32F: metres of water along the mean light from where it enters the flat
/// surface to the first receiver, 1e30 for none; the receiver's number. Row 0 is at the rectangle's corner.
class SceneDepthPass {
  public:
    explicit SceneDepthPass(gl::Context& context);

    /// `farthest`: an upper bound on metres of water to any receiver. `beams.frame` says light and rectangle.
    void draw(gl::Texture& map, glm::ivec2 size, const Beams& beams,
              std::span<const ReceiverGeometry> receivers, double farthest);

  private:
    gl::Context& _context;
    gl::Program _program;
};

} // namespace limpid
