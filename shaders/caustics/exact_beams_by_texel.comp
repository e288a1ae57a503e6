// Exact beams, the pass over the quads that exact_beams.comp left in a list: every texel that a beam touches takes its part.
// One invocation for the two beams of a quad. In: footprints, flux, tangent planes, depth pyramid, the list. Out: flux
// sums, one channel or three (COLOURED); see beam_touch.glsl for EXTINCTION and SHADED.
// LARGE: the tiles of the quads of all lists that touch many texels, which the passes over the lists left.
#include "interface/bindings.glsl"
#include "caustics/beam_touch.glsl"
#include "caustics/beam_walk.glsl"
#include "caustics/beam_lists.glsl"
layout(location = listLocation) uniform int list;

bool leaveSlab(int index, int number, Slab slab) { return leaveToMany(index, number, slab.low, slab.high); }
void visit(Quad quad, int index, Slab slab, ivec2 texel, float depth) { touch(quad, index, texel); }

void main() {
#ifdef LARGE
    walkTiles();
#else
    int count = int(work[list].w), step = int(gl_NumWorkGroups.x * gl_WorkGroupSize.x);
    for (int i = int(gl_GlobalInvocationID.x); i < count; i += step) walk(listed[list * quads.x * quads.y + i]);
#endif
}
