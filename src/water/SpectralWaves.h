#pragma once
#include <memory>
#include <optional>

#include "gl/Context.h"
#include "gl/Handles.h"
#include "gl/Program.h"
#include "scene/Spectrum.h"

namespace limpid {

/// A spectrum as it is on the GPU, and its tile at one time.
struct SpectralTile {
    std::shared_ptr<const Spectrum> spectrum;
    gl::Buffer modes, turns, lines;
    /// R32F: coefficients of a periodic bicubic B-spline, for a root mean square height of 1 m; texel 0 is at
    /// the origin of the world.
    gl::Texture heights;
    std::optional<double> time;
};

/// Waves by inverse Fourier transform (Tessendorf eq. 19), in two passes of compute: rows, then columns.
///
/// The tile has eight texels for each mode, so that the spline through them follows even the shortest waves:
/// with four, places between them were up to 1.6e-5 of the root mean square height off, with one it is
/// percents.
class SpectralWaves {
  public:
    explicit SpectralWaves(gl::Context& context);

    /// Texels a mode.
    static constexpr int finer = 8;
    /// Brings `tile` to `spectrum` and `time` (s).
    void update(SpectralTile& tile, const std::shared_ptr<const Spectrum>& spectrum, double time);

  private:
    void upload(SpectralTile& tile, const Spectrum& spectrum);
    gl::Context& _context;
    gl::Program _rows, _columns;
};

} // namespace limpid
