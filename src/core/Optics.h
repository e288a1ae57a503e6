#pragma once
#include <glm/glm.hpp>

#include "core/ShaderData.h"

/// The shaders' physics on the CPU: in double precision for set-up (namespace optics) and in the shaders' own
/// single precision (namespace shader). The lines are the same, from shaders/optics.

// Not every file that includes this calls every function.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#ifdef __clang__
#pragma GCC diagnostic ignored "-Wkeyword-macro"
#endif

namespace limpid::optics {
namespace {
using namespace glm;
// The included files say float and vec3; this makes them mean double here.
#define float double
#define vec3 dvec3
#include "optics/cone.glsl"
#include "optics/optics.glsl"
#include "optics/planes.glsl"
#undef float
#undef vec3
} // namespace
} // namespace limpid::optics

namespace limpid::shader {
namespace {
using namespace glm;
using gpu::WaveTerm;
#include "optics/beam_area.glsl"
#include "optics/octahedral.glsl"
#include "optics/optics.glsl"
#include "optics/phase.glsl"
#include "optics/planes.glsl"
#include "optics/shaft_cuts.glsl"
#include "optics/spline.glsl"
#include "optics/tetrahedron.glsl"
#include "optics/water_grid.glsl"
#include "optics/waves.glsl"
} // namespace
} // namespace limpid::shader

#pragma GCC diagnostic pop
