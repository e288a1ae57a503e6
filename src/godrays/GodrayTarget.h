#pragma once
#include "gl/Blending.h"
#include "gl/Context.h"
#include "gl/NearIsOne.h"
#include "gl/Program.h"
#include "godrays/Godrays.h"

namespace limpid {

/// While it lives, depth runs from 1 near by to 0 far away and is tested.
struct NearIsOneTested : gl::NearIsOne {
    NearIsOneTested() { glEnable(GL_DEPTH_TEST); }
    ~NearIsOneTested() { glDisable(GL_DEPTH_TEST); }
};

/// While it lives, what is drawn is added and leaves depth alone.
struct AddingBehindDepth : gl::Adding {
    AddingBehindDepth() { glDepthMask(GL_FALSE); }
    ~AddingBehindDepth() { glDepthMask(GL_TRUE); }
};

/// What light in the water is drawn into, and what ends the rays to it: receivers, and the water's surface
/// seen from below.
class GodrayTarget {
  public:
    explicit GodrayTarget(gl::Context& context);

    /// Whether the surface stands in `depth`: lines end there and would lose the rim of what is drawn wider
    /// than it is.
    enum class Surface { Blended, Solid };
    /// Black, `scale` times the picture's size; the frame is bound.
    void begin(const GodrayInputs& inputs, Surface surface);
    /// RGBA32F, row 0 at the bottom: W/(m² sr); alpha 1 over the metres along the view to what ends it, 0 for
    /// nothing.
    const gl::Texture& radiance() const { return _radiance; }
    /// Of that, near plane over metres along the view.
    const gl::Texture& depth() const { return _depth; }
    /// Binds the radiance with depth, or alone so that depth can be read.
    void bind() const { _target.bind(); }
    void bindWithoutDepth() const { _flat.bind(); }

  private:
    void resize(glm::ivec2 size);
    gl::Context& _context;
    gl::Program _receivers, _surface;
    gl::Texture _radiance, _depth;
    gl::Framebuffer _target, _flat;
};

} // namespace limpid
