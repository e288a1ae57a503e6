// Walks the texels that a quad may touch; calls `visit` for each whose surface is at a depth that the walk is at there.
#include "caustics/beam_cut.glsl"
#include "caustics/large_beams.glsl"

void visit(Quad quad, int index, ivec2 texel);
// Whether a slab of many texels is left to a later pass; `number` says which slab of the quad it is.
bool leaveSlab(int index, int number, Slab slab);

// Texels of a slab that one invocation walks. Shade may ask for hundreds of triangles at each of them.
#ifdef SHADED
const int mostWalked = 4;
#else
const int mostWalked = mostTexels;
#endif

// Of a tile: the depths of the quad were found as one slab.
const int settled = -1;

void visitWithin(Quad quad, int index, Slab slab, ivec2 texel) {
    float depth = texelFetch(tangentPlanes, texel, 0).x;
    if (depth >= slab.from && depth < slab.to) visit(quad, index, texel);
}

void walkSlab(Quad quad, Slab slab, int index, int number) {
    int count = texelsOf(slab);
    if (count > mostWalked && leaveSlab(index, number, slab)) return;
    ivec2 texel = slab.low;
    for (int i = 0; i < count; ++i) {
        visitWithin(quad, index, slab, texel);
        if (++texel.x > slab.high.x) texel = ivec2(slab.low.x, texel.y + 1);
    }
}

void walk(int index) {
    Quad quad;
    if (!loadQuad(index, quad)) return;
    vec4 a = quad.p, b = quad.q, c = quad.r, d = quad.s;
    Slab slab;
    vec2 depths;
    if (lean(a) && lean(b) && lean(c) && lean(d)) {
        if (!settle(a, b, c, d, slab, depths)) return;
        if (isOneSlab(slab, depths)) {
            walkSlab(quad, slab, index, settled);
            return;
        }
    }
    int slabs = slabsAlong(quad), run = slabs;
    for (int i = 0; i < slabs;) {
        bool met = slabAlong(quad, i, run, slabs, slab);
        if (met && run > 1) {
            run /= 2;
            continue;
        }
        if (met) walkSlab(quad, slab, index, i);
        i += run;
        run = i & -i;
    }
}
