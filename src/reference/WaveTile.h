#pragma once
#include <memory>
#include <vector>

#include <glm/glm.hpp>

#include "scene/Spectrum.h"

namespace limpid::reference {

/// The surface that a spectrum makes at one time, in double precision: its own transform of the modes that
/// the scene has, sampled eight times as finely as there are modes, or 4096 times, and a cubic spline through
/// that.
class WaveTile {
  public:
    WaveTile(const Spectrum& spectrum, double time);

    /// Height and slopes along x and z at `place` (m; the tile repeats), for a root mean square of 1 m.
    glm::dvec3 at(const glm::dvec2& place) const;

  private:
    glm::dvec2 _texels; ///< a metre
    int _side = 0;      ///< texels, a power of two
    std::vector<double> _spline;
};

} // namespace limpid::reference
