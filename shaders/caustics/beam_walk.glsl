// Exact beams: the walk over the texels that a quad may touch.
#include "caustics/beam_cut.glsl"
#include "caustics/quad_walk.glsl"

float depthOf(ivec2 texel) { return texelFetch(tangentPlanes, texel, 0).x; }

bool slabAlong(Quad quad, vec2 depths, int index, int run, int count, out Slab slab) {
    return slabAlong(quad, index, run, count, slab);
}

#ifdef LARGE
bool findSlab(Quad quad, int number, out Slab slab) {
    if (number != settled) return slabAlong(quad, number, 1, slabsAlong(quad, boxExtent.z), slab);
    Leant leant;
    vec2 depths;
    lean(quad, leant);
    return settle(leant, slab, depths);
}
#endif

void walk(int index) {
    Quad quad;
    if (!loadQuad(index, quad)) return;
    Leant leant;
    Slab slab;
    vec2 depths = vec2(0.0, boxExtent.z);
    if (lean(quad, leant)) {
        if (!settle(leant, slab, depths)) return;
        if (isOneSlab(slab, depths)) {
            walkSlab(quad, slab, index, settled);
            return;
        }
    }
    walkSlabs(quad, index, depths, slabsAlong(quad, boxExtent.z));
}
