#pragma once
#include <cstdint>

#include <glm/glm.hpp>

/// Data that C++ and shaders hand each other, from the same lines (shaders/interface): structs as they lie in
/// blocks of uniforms and of storage; of a block that ends in an array without end, what comes before it.
namespace limpid::gpu {

using namespace glm;

// clang-format off
#include "interface/box_frame.glsl"
#include "interface/light_frame.glsl"
#include "interface/view_frame.glsl"
#include "interface/godray_frame.glsl"
#include "interface/wave_term.glsl"
#include "interface/wave_mode.glsl"
#include "interface/vertex.glsl"
#include "interface/occluders.glsl"
#include "interface/coverage_lean.glsl"
#include "interface/sub_box.glsl"
#include "interface/ray_bounds.glsl"
#include "interface/kept_tiles.glsl"
#include "interface/beam_lists.glsl"
#include "interface/beam_touches.glsl"
#include "interface/photons_left.glsl"
#include "interface/draw_command.glsl"
#include "interface/shaft_gap.glsl"
#include "interface/volume_starts.glsl"
// clang-format on

// Blocks of uniforms are read in steps of 16 bytes (std140); an element of an array as its own size says
// (std430).
template <typename Block>
constexpr bool fitsUniforms = sizeof(Block) % sizeof(vec4) == 0;
static_assert(fitsUniforms<BoxFrame> && fitsUniforms<LightFrame> && fitsUniforms<ViewFrame> &&
              fitsUniforms<GodrayFrame>);
static_assert(sizeof(WaveTerm) == 64 && sizeof(Mode) == 16 && sizeof(SubBox) == 16 &&
              sizeof(RayBounds) == 64);
static_assert(sizeof(OccluderNode) == 32 && sizeof(OccluderTriangle) == 48 && sizeof(VeilTriangle) == 80);
static_assert(sizeof(LeftPhoton) == 64 && sizeof(PhotonsLeft) == 16);
static_assert(sizeof(Kept) == 20 && sizeof(BeamLists) == 80 && sizeof(BeamTouches) == 24);
static_assert(sizeof(Gap) == 32 && sizeof(VolumeStarts) == 16 && sizeof(DrawCommand) == 16);

} // namespace limpid::gpu
