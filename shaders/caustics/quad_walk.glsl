// Walks the texels that a quad may touch; calls `visit` for each whose depth is one that the walk is at there.
#include "caustics/quad_span.glsl"
#include "caustics/large_beams.glsl"
layout(local_size_x = 64) in;

// What the pass does with a texel at this depth.
void visit(Quad quad, int index, Slab slab, ivec2 texel, float depth);
// The depth of a texel, m.
float depthOf(ivec2 texel);
// Whether a slab of many texels is left to a later pass; `number` says which slab of the quad it is.
bool leaveSlab(int index, int number, Slab slab);
// Of a quad that is not walked at once: `run` slabs from `index` of `count` between two depths; false if the quad meets
// nothing there.
bool slabAlong(Quad quad, vec2 depths, int index, int run, int count, out Slab slab);

// Texels of a slab that one invocation walks. Shade may ask for hundreds of triangles at each of them.
#ifdef SHADED
const int mostWalked = 4;
#else
const int mostWalked = mostTexels;
#endif

// Of a tile: the depths of the quad were found as one slab.
const int settled = -1;

void visitWithin(Quad quad, int index, Slab slab, ivec2 texel) {
    float depth = depthOf(texel);
    if (depth >= slab.from && depth < slab.to) visit(quad, index, slab, texel, depth);
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

void walkSlabs(Quad quad, int index, vec2 depths) {
    int count = slabsAlong(quad, depths.y - depths.x), run = count;
    for (int i = 0; i < count;) {
        Slab slab;
        bool met = slabAlong(quad, depths, i, run, count, slab);
        if (met && run > 1) {
            run /= 2;
            continue;
        }
        if (met) walkSlab(quad, slab, index, i);
        i += run;
        run = i & -i;
    }
}

#ifdef LARGE
// The slab of this number, as walkSlabs has them.
bool slabOf(Quad quad, vec2 depths, int number, out Slab slab) {
    return slabAlong(quad, depths, number, 1, slabsAlong(quad, depths.y - depths.x), slab);
}

// The slab that a tile was cut from.
bool findSlab(Quad quad, int number, out Slab slab);

// One work group a tile.
void walkTiles() {
    int count = min(tileCount, tiles.length());
    for (int item = int(gl_WorkGroupID.x); item < count; item += int(gl_NumWorkGroups.x)) {
        ivec4 tile = tiles[item];
        Quad quad;
        Slab slab;
        if (tile.x < 0 || !loadQuad(tile.x, quad) || !findSlab(quad, tile.y, slab)) continue;
        for (int i = int(gl_LocalInvocationIndex); i < tileSide * tileSide; i += int(gl_WorkGroupSize.x)) {
            ivec2 texel = tile.zw + ivec2(i % tileSide, i / tileSide);
            if (all(lessThanEqual(texel, slab.high))) visitWithin(quad, tile.x, slab, texel);
        }
    }
}
#endif
