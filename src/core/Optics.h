#pragma once
#include <glm/glm.hpp>

/// The shaders' physics on the CPU: in double precision for set-up (namespace optics) and in the shaders' own
/// single precision (namespace shader). The lines are the same, from shaders/include.

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
#include "include/cone.glsl"
#include "include/optics.glsl"
#include "include/planes.glsl"
#undef float
#undef vec3
} // namespace
} // namespace limpid::optics

namespace limpid::shader {
namespace {
using namespace glm;
#include "include/beam_area.glsl"
#include "include/octahedral.glsl"
#include "include/optics.glsl"
#include "include/phase.glsl"
#include "include/planes.glsl"
#include "include/shaft_cuts.glsl"
#include "include/spline.glsl"
#include "include/tetrahedron.glsl"
#include "include/water_grid.glsl"
#include "include/waves.glsl"
} // namespace
} // namespace limpid::shader

#pragma GCC diagnostic pop
