#pragma once
#include <vector>

#include <glm/glm.hpp>

#include "core/ShaderData.h"
#include "scene/Scene.h"

namespace limpid {

/// The waves at `time` (s), without height maps and spectra, for positions relative to `origin` (m). What
/// grows with time or distance is reduced in double precision here, so that a float has to hold one period at
/// most.
std::vector<gpu::WaveTerm> waveTerms(const Water& water, const glm::dvec3& origin, double time);

/// A bound on the surface's slope (rise over run) that no place and time exceeds; noise is bounded by what
/// its lattice can reach, a height map by the coefficients of its first frame, a spectrum as Spectrum has it.
double steepestSlope(const Water& water);
double steepestSlope(const Wave& wave);

/// Whether the surface differs between two times.
bool moves(const Water& water);

/// Whether the surface may have changed though the time has not: a host's texture.
bool isLive(const Water& water);

/// A bound on how far the surface leaves its mean level, m.
double highestWave(const Water& water);
double highestWave(const Wave& wave);

} // namespace limpid
