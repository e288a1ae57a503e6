#pragma once
#include <span>
#include <vector>

#include "caustics/CausticMap.h"
#include "gl/Context.h"
#include "gl/Program.h"
#include "levelmap/LevelMap.h"
#include "levelmap/ReceiverGeometry.h"
#include "scene/Scene.h"
#include "water/Beams.h"

namespace limpid {

/// How receivers come into a view (shaders/include/view.glsl): as they are; through the flat surface, for
/// those on its far side; mirrored in it.
enum class Way { Straight, Refracted, Mirrored };

/// One receiver's light by one of its maps.
struct Lit {
    int receiver;
    const LevelMap* level;
    const CausticMap* caustics;
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
    };
    /// Makes the caustic maps ready to be projected; `draw` shows these.
    void prepare(const Inputs& inputs);
    /// Adds to `target`: radiance and position (shaders/view/receiver.frag), depth (1 near by, 0 far
    /// away); all cleared by the caller. The view frame is bound.
    void draw(const Inputs& inputs, const gl::Framebuffer& target, Side side, Way way);

  private:
    void addCaustics(const Inputs& inputs, std::size_t receiver);
    void addDirectLight(const Inputs& inputs, std::size_t receiver, Side side);

    gl::Context& _context;
    gl::Program _castMap, _receiver;
    std::vector<gl::Texture> _casts; ///< one for each of `lit`
};

} // namespace limpid
