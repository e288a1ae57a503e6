#pragma once
#include <vector>

#include "gl/Context.h"
#include "gl/Handles.h"
#include "gl/Program.h"
#include "view/Picture.h"

namespace limpid::viewer {

/// How pictures become what the window shows.
struct Shown {
    enum class Mode { One, Split, Difference };
    double exposure = 0; ///< stops
    Mode mode = Mode::One;
    double split = 0.5;     ///< Mode::Split: share of the width that is left to the first
    double difference = 10; ///< Mode::Difference: multiplies the difference of displayed colours

    bool operator==(const Shown&) const = default;
};

/// Tone-maps pictures for a window as view/PictureResolve.h does for files.
class Display {
  public:
    explicit Display(gl::Context& context);

    /// `second` is that of the other method; null for Mode::One. Both have the same size.
    void show(const PicturePass::Sketch& first, const PicturePass::Sketch* second, const Shown& shown);
    /// RGBA8, sRGB, row 0 at the bottom.
    const gl::Texture& picture() const { return _picture; }
    /// Its pixels, RGB, rows from the top. Waits for the GPU.
    std::vector<std::uint8_t> pixels() const;

  private:
    gl::Context& _context;
    gl::Program _program;
    gl::VertexArray _noVertices;
    gl::Texture _picture;
    gl::Framebuffer _target;
};

} // namespace limpid::viewer
