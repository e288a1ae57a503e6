// Exact beams, the first pass over the quads that may be shaded: finds the texels that each touches, for
// exact_beams_touches.comp. Following light through what may shade it is dear; a quad's texels are done one by one there,
// by as many invocations, and none waits for its neighbours' longer walks.
// One invocation a quad. In: footprints, flux, tangent planes, depth pyramid, the list. Out: touches; quads whose touches
// found no room, in the list `wide`.
#include "caustics/beam_cut.glsl"
#include "caustics/beam_walk.glsl"
#include "caustics/beam_lists.glsl"
#include "caustics/beam_touches.glsl"

bool leaveSlab(int index, int number, Slab slab) { return false; }

// Few quads touch more texels: those are walked a second time.
const int mostKept = 32;
int found = 0, place = -1; // touches of the quad so far; where they go, < 0 in the first walk
int kept[mostKept];

void visit(Quad quad, int index, Slab slab, ivec2 texel, float depth) {
    if (!mayTouch(cutAt(quad, texel))) return;
    int number = texel.y * boxSize.x + texel.x;
    if (place >= 0) touches[place + found] = ivec2(index, number);
    else if (found < mostKept) kept[found] = number;
    ++found;
}

void gather(int index) {
    found = 0, place = -1;
    walk(index);
    if (found == 0) return;
    place = reserveTouches(found);
    if (place < 0) {
        leaveTo(wide, index);
    } else if (found <= mostKept) {
        for (int i = 0; i < found; ++i) touches[place + i] = ivec2(index, kept[i]);
    } else {
        found = 0;
        walk(index);
    }
}

void main() {
    int count = int(work[shaded].w), step = int(gl_NumWorkGroups.x * gl_WorkGroupSize.x);
    for (int i = int(gl_GlobalInvocationID.x); i < count; i += step) gather(listed[shaded * quads.x * quads.y + i]);
}
