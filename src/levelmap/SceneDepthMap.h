#pragma once
#include <optional>
#include <span>

#include "gl/Context.h"
#include "gl/Handles.h"
#include "gl/Program.h"
#include "levelmap/DepthPyramid.h"
#include "levelmap/ReceiverGeometry.h"
#include "water/Beams.h"

namespace limpid {

/// The part of the flat surface where the mean light enters that reaches any of `points` (submerged, in the
/// world), as LightFrameData wants it: x, z of a corner and extents, m from the scene's origin. A margin
/// keeps the outermost points inside.
glm::vec4 sceneDepthRect(const Light& light, const Water& water, std::span<const glm::dvec3> points,
                         const glm::dvec3& origin);

/// What one light hits first, seen along the mean light from where it enters the flat surface. Row 0 is at
/// the rectangle's corner; depths are metres of water along the mean light.
struct SceneDepth {
    /// RG32F: depth of the first receiver, 1e30 for none; its number, and a half if its face is met from
    /// behind.
    gl::Texture first;
    /// RGBA32F, all levels: least and greatest depth at which what is first is entered, least depth at which
    /// it is left again, its number. Where a receiver has no back, it is left where it is
    /// entered.
    gl::Texture pyramid;
    /// RG32F: where what lies beyond the first solid is entered and where it is left, 1e30 for none.
    gl::Texture second;

    /// To the units that shaders/include/scene_depth.glsl and occlusion.glsl read.
    void bind() const;
};

class SceneDepthPass {
  public:
    explicit SceneDepthPass(gl::Context& context);

    struct Inputs {
        const Beams& beams; ///< its frame says light and rectangle
        std::span<const ReceiverGeometry> receivers;
        double farthest; ///< an upper bound on metres of water to any receiver
    };
    /// `first` alone: all that is needed where the mean light decides.
    void drawFirst(SceneDepth& depth, glm::ivec2 size, const Inputs& inputs);
    /// The pyramid, for what goes by a beam's own direction.
    void drawSolids(SceneDepth& depth, const Inputs& inputs);
    /// `second`, after the pyramid.
    void drawSecondSolids(SceneDepth& depth, const Inputs& inputs);

  private:
    enum class Solid { First, Second };
    void drawReceivers(const gl::Program& program, glm::ivec2 size, const Inputs& inputs, Solid solid);
    void drawEntered(const gl::Texture& entered, const Inputs& inputs, Solid solid);
    void drawLeft(const gl::Texture& entered, const gl::Texture& out, const Inputs& inputs, Solid solid);
    gl::Context& _context;
    gl::Program _first, _exit, _range, _rangeOfSecond;
    DepthPyramidPass _pyramid;
};

} // namespace limpid
