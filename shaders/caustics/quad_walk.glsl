// Walks the texels that a quad may touch; calls `visit` for each whose depth is one that the walk is at there. One invocation
// walks a narrow quad; BROAD: a work group a broad one, or several that share it, so that no invocation has a long way.
#include "caustics/quad_span.glsl"
layout(local_size_x = 64) in;

// Where the texels of a quad are: in the slab that its depths settled on, or in some of many slabs.
struct Place {
    int slabs; // 0: nowhere
    bool settled;
    Slab slab;   // where settled
    vec2 depths; // that slabs are cut from
};

// What the pass does with a texel at this depth.
void visit(Quad quad, int index, Slab slab, ivec2 texel, float depth);
// The depth of a texel, m.
float depthOf(ivec2 texel);
Place placeOf(Quad quad);
// A slab of `count` between two depths; false if the quad meets nothing there.
bool slabAlong(Quad quad, vec2 depths, int number, int count, out Slab slab);

Place nowhere() {
    Place place;
    place.slabs = 0, place.settled = false;
    return place;
}

bool isAt(Slab slab, float depth) { return depth >= slab.from && depth < slab.to; }

void visitWithin(Quad quad, int index, Slab slab, ivec2 texel) {
    float depth = depthOf(texel);
    if (isAt(slab, depth)) visit(quad, index, slab, texel, depth);
}

void walkNarrow(Quad quad, int index, Slab slab) {
    ivec2 texel = slab.low;
    int count = texelsOf(slab);
    for (int i = 0; i < count; ++i) {
        visitWithin(quad, index, slab, texel);
        if (++texel.x > slab.high.x) texel = ivec2(slab.low.x, texel.y + 1);
    }
}

// Of a slab's texels, row by row, the first that falls to this invocation of those that share the quad; then every so many.
int firstOf(int number, int part, int parts) { return 64 * ((part + parts - number % parts) % parts) + int(gl_LocalInvocationIndex); }
int stepOf(int parts) { return 64 * parts; }
ivec2 texelOf(Slab slab, int i) {
    int across = slab.high.x - slab.low.x + 1;
    return slab.low + ivec2(i % across, i / across);
}

#ifdef BROAD
void walkPart(Quad quad, int index, Slab slab, int number, int part, int parts) {
    int count = texelsOf(slab);
    for (int i = firstOf(number, part, parts); i < count; i += stepOf(parts)) visitWithin(quad, index, slab, texelOf(slab, i));
}

shared int metCount;
shared int met[mostSlabs]; // slabs in which the quad meets something

// The part of a quad that falls to this work group, all of which calls it alike.
void walk(Quad quad, int index, int part, int parts) {
    Place place = placeOf(quad);
    if (place.settled) {
        walkPart(quad, index, place.slab, 0, part, parts);
        return;
    }
    int lane = int(gl_LocalInvocationIndex);
    Slab slab;
    barrier(); // the quad before is done with
    if (lane == 0) metCount = 0;
    barrier();
    for (int i = lane; i < place.slabs; i += 64)
        if (slabAlong(quad, place.depths, i, place.slabs, slab)) met[atomicAdd(metCount, 1)] = i;
    barrier();
    for (int i = 0; i < metCount; ++i) {
        slabAlong(quad, place.depths, met[i], place.slabs, slab);
        walkPart(quad, index, slab, met[i], part, parts);
    }
}
#else
void walk(Quad quad, int index, int part, int parts) { walkNarrow(quad, index, placeOf(quad).slab); }
#endif
