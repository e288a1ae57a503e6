#pragma once
#include "gl/Context.h"
#include "gl/Handles.h"
#include "gl/Program.h"
#include "scene/HeightField.h"

namespace limpid {

/// The spline through heights that a host has in a texture (scene/HostWater.h): coefficients as HeightField
/// has them, R32F, that go on beyond the edge.
class HostHeights {
  public:
    explicit HostHeights(gl::Context& context);
    ~HostHeights();
    HostHeights(const HostHeights&) = delete;
    HostHeights& operator=(const HostHeights&) = delete;

    /// Reads the heights as they are now into `spline`, made if need be. The texture exists, R32F, as large
    /// as source's bounds say.
    void update(gl::Texture& spline, const HeightSource& source);

  private:
    gl::Context& _context;
    gl::Program _program;
    gl::Texture _alongX;
    GLuint _nearest =
        0; ///< a sampler: a texture without mipmaps is whole by it, whatever filter a host has set
};

} // namespace limpid
