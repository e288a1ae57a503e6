#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "core/Picture.h"
#include "gl/Context.h"
#include "gl/Handles.h"
#include "gl/Program.h"

namespace limpid {

/// Luminance, after exposure, that is shown as white. A white wall in the default sun stays below it; only a
/// caustic's core reaches it.
inline constexpr float whiteLuminance = 4.0f;

/// Averages the samples of a picture's pixels on the GPU and reads back the pixels alone. Both wait for the
/// GPU. Samples: RGBA32F, linear radiance, W/(m² sr), row 0 at the bottom, `perPixel` · `perPixel` a pixel.
class PictureResolve {
  public:
    explicit PictureResolve(gl::Context& context) : _context(context) {}

    Picture linear(const gl::Texture& samples, int perPixel);
    /// 8-bit sRGB, RGB, rows from the top: `exposure` in stops, then Reinhard's curve on luminance, dithered.
    std::vector<std::uint8_t> toneMapped(const gl::Texture& samples, int perPixel, double exposure);
    /// Gives back the memory that stays for the next picture of the same size.
    void forget() { _pixels = {}; }

  private:
    void resolve(const gl::Program& program, GLenum format, const gl::Texture& samples, int perPixel);

    gl::Context& _context;
    std::optional<gl::Program> _linear, _toneMapped; ///< each made at first use
    gl::Texture _pixels;                             ///< RGBA32F or RGBA8, rows from the top
};

} // namespace limpid
