#pragma once
#include <optional>
#include <span>

#include "gl/Context.h"
#include "gl/Handles.h"
#include "gl/Program.h"
#include "levelmap/ReceiverGeometry.h"
#include "water/Beams.h"

namespace limpid {

/// What one light hits first, seen along the mean light from where it enters the flat surface. Row 0 is at
/// the rectangle's corner; depths are metres of water along the mean light.
struct SceneDepth {
    /// RG32F: depth of the first receiver, 1e30 for none; its number, and a half if its face is met from
    /// behind.
    gl::Texture first;

    /// To the unit that shaders/levelmap/scene_depth.glsl reads.
    void bind() const;
};

class SceneDepthPass {
  public:
    explicit SceneDepthPass(gl::Context& context) : _context(context) {}

    struct Inputs {
        const Beams& beams; ///< its frame says light and rectangle
        std::span<const ReceiverGeometry> receivers;
        double farthest; ///< an upper bound on metres of water to any receiver
    };
    /// Makes or overwrites the map; what lets some light through is not in it.
    void draw(SceneDepth& depth, glm::ivec2 size, const Inputs& inputs);

  private:
    gl::Context& _context;
    std::optional<gl::Program> _program; ///< made for the first map
};

} // namespace limpid
