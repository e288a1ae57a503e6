#pragma once
#include <array>

#include "engine/Engine.h"
#include "gl/Program.h"

namespace limpid::viewer {

/// The maps of a receiver and a light as pictures for the eye.
class MapImages {
  public:
    enum Kind { Position, Diffuse, Normal, Caustic };
    static constexpr int count = 4;

    explicit MapImages(gl::Context& context);

    /// `gain`: what irradiance is multiplied with before it is tone-mapped.
    void update(const MapWork& maps, double gain);
    /// RGBA8, row 0 the top of the box, in the first `size` pixels; always the same texture, which the
    /// interface may have yet to draw.
    const gl::Texture& image(Kind kind) const { return _images[std::size_t(kind)]; }
    glm::ivec2 size() const { return _size; }

  private:
    gl::Context& _context;
    gl::Program _program;
    gl::VertexArray _noVertices;
    std::array<gl::Texture, count> _images;
    glm::ivec2 _size{1};
};

} // namespace limpid::viewer
