// Exact beams, the pass over the quads that exact_beams.comp left in a list: every texel that a beam touches takes its part.
// One invocation for the two beams of a quad. In: footprints, flux, tangent planes, depth pyramid, the list. Out: flux
// sums, one channel or three (COLOURED); see beam_touch.glsl for EXTINCTION and SHADED.
// LARGE: the tiles of the quads of all lists that touch many texels, which the passes over the lists left.
#include "interface/bindings.glsl"
#include "caustics/beam_touch.glsl"
#include "caustics/beam_walk.glsl"
#include "caustics/beam_lists.glsl"
layout(local_size_x = 64) in;
layout(location = listLocation) uniform int list;

bool leaveSlab(int index, int number, Slab slab) { return leaveToMany(index, number, slab.low, slab.high); }
void visit(Quad quad, int index, ivec2 texel) { touch(quad, index, texel); }

#ifdef LARGE
// One work group a tile.
void main() {
    ivec4 tile = tiles[gl_WorkGroupID.x];
    Quad quad;
    if (tile.x < 0 || !loadQuad(tile.x, quad)) return;
    vec4 a = quad.p, b = quad.q, c = quad.r, d = quad.s;
    Slab slab;
    vec2 depths;
    if (tile.y == settled) {
        lean(a), lean(b), lean(c), lean(d);
        settle(a, b, c, d, slab, depths);
    } else {
        slabAlong(quad, tile.y, 1, slabsAlong(quad), slab);
    }
    for (int i = int(gl_LocalInvocationIndex); i < tileSide * tileSide; i += int(gl_WorkGroupSize.x)) {
        ivec2 texel = tile.zw + ivec2(i % tileSide, i / tileSide);
        if (all(lessThanEqual(texel, slab.high))) visitWithin(quad, tile.x, slab, texel);
    }
}
#else
void main() {
    int count = int(work[list].w), step = int(gl_NumWorkGroups.x * gl_WorkGroupSize.x);
    for (int i = int(gl_GlobalInvocationID.x); i < count; i += step) walk(listed[list * quads.x * quads.y + i]);
}
#endif
