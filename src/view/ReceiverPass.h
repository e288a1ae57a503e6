#pragma once
#include <span>
#include <vector>

#include "caustics/CausticMap.h"
#include "core/Kept.h"
#include "gl/Context.h"
#include "gl/Program.h"
#include "levelmap/LevelMap.h"
#include "levelmap/ReceiverGeometry.h"
#include "plan/Sides.h"
#include "scene/Scene.h"
#include "water/Beams.h"

namespace limpid {

/// How receivers come into a view (shaders/view/view.glsl): as they are; through the flat surface, for
/// those on its far side; mirrored in it.
enum class Way { Straight, Refracted, Mirrored };

/// One receiver's light by one of its maps.
struct Lit {
    int receiver;
    const LevelMap* level;
    const CausticMap* caustics;
    Stamp filled; ///< when `caustics` was
};

/// Draws the receivers on one side of the water, lit by their caustic maps, by lights that come straight and
/// by the ambient light.
class ReceiverPass {
  public:
    explicit ReceiverPass(gl::Context& context);

    struct Inputs {
        const Scene& scene;
        std::span<const ReceiverGeometry> receivers;
        std::span<const Lit> lit;
        std::span<const Beams* const> lights; ///< in the scene's order
        const gl::Buffer& surfacePositions;   ///< of the water, as WaterMesh has it
        glm::vec3 camera;                     ///< m from the scene's origin
    };
    /// Makes the caustic maps ready to be projected; `draw` shows these.
    void prepare(const Inputs& inputs);
    /// Adds to `target`: radiance, distance if it has one (shaders/view/receiver.frag), depth (1 near by, 0
    /// far away); all cleared by the caller. The view frame is bound.
    void drawSolid(const Inputs& inputs, const gl::Framebuffer& target, Side side, Way way);
    /// What lets something show through, over all that is in `target`; it leaves depth alone.
    void drawBlended(const Inputs& inputs, const gl::Framebuffer& target, Side side, Way way);

  private:
    /// What is drawn at once: what of a receiver hides all behind it, or one of its blended parts.
    struct Drawn {
        std::size_t receiver;
        const ReceiverGeometry::BlendedPart* blended = nullptr;
    };
    void drawOnce(const Inputs& inputs, const Drawn& drawn);
    void addCaustics(const Inputs& inputs, const Drawn& drawn);
    void addDirectLight(const Inputs& inputs, const Drawn& drawn, Side side);
    void drawLit(const Inputs& inputs, const Drawn& drawn, Side side);
    void begin(const Inputs& inputs, const gl::Framebuffer& target, Side side, Way way);
    void end();

    gl::Context& _context;
    gl::Program _castMap, _receiver;
    std::vector<gl::Texture> _casts; ///< one for each of `lit`
    std::vector<Stamp> _castsOf;     ///< when the caustic maps were filled that they are made of
};

} // namespace limpid
