// Exact beams, the touches of quads that may be shaded: one invocation for a quad's beams on one texel. What is in the list of
// touches, or else what found no room in it: both in this program, at one place of it, so that no bit depends on which quads
// came first.
// In: touches (exact_beams_gather.comp), footprints, flux, tangent planes; depth pyramid and the list `left`. Out: flux sums,
// one channel or three (COLOURED); see beam_touch.glsl for EXTINCTION and SHADED.
#include "caustics/beam_touch.glsl"
#include "caustics/beam_walk.glsl"
#include "caustics/beam_lists.glsl"
#include "caustics/beam_touches.glsl"
layout(location = listLocation) uniform int list; // left, or another for the list of touches

void visit(Quad quad, int index, Slab slab, ivec2 texel, float depth) {}

// What an invocation is at of what found no room: an entry of `left`, a slab of its quad, a texel in that.
struct Cursor {
    int item, slab, texel;
};

// `touched`: as the list has it; false where there is no more.
bool nextLeft(inout Cursor at, out ivec2 touched) {
    int parts = int(work[shaded + broad].y), count = quads.x * quads.y;
    while (at.item < countIn(left)) {
        int entry = listedIn(left, at.item), part = entry / count, index = entry % count;
        Quad quad;
        loadQuad(index, quad);
        Place place = placeOf(quad);
        Slab slab = place.slab;
        if (at.texel < 0) at.texel = firstOf(at.slab, part, parts);
        bool met = at.slab < place.slabs && (place.settled || slabAlong(quad, place.depths, at.slab, place.slabs, slab));
        if (met && at.texel < texelsOf(slab)) {
            ivec2 texel = texelOf(slab, at.texel);
            touched = ivec2(index, texel.y * boxSize.x + texel.x);
            at.texel += stepOf(parts);
            if (isAt(slab, depthOf(texel))) return true;
            continue;
        }
        at.texel = -1;
        if (++at.slab < place.slabs) continue;
        at.slab = 0;
        at.item += int(gl_NumWorkGroups.x);
    }
    return false;
}

// One loop over what is listed, which has one touch at a time of what is left.
void main() {
    bool listed = list != left, more = listed;
    Cursor at = Cursor(int(gl_WorkGroupID.x), 0, -1);
    int item = int(gl_GlobalInvocationID.x), end = touchCount.x, step = int(gl_NumWorkGroups.x * gl_WorkGroupSize.x);
    do {
        ivec2 touched = ivec2(0);
        if (!listed) {
            more = nextLeft(at, touched);
            item = 0, end = more ? 1 : 0;
        }
        for (; item < end; item += step) {
            if (listed) touched = touches[item];
            Quad quad;
            if (loadQuad(touched.x, quad)) touch(quad, touched.x, ivec2(touched.y % boxSize.x, touched.y / boxSize.x));
        }
    } while (!listed && more);
}
