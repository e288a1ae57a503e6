// Exact beams, the first pass over the quads that may be shaded: finds the texels that each touches, for
// exact_beams_touches.comp. Following light through what may shade it is dear; a quad's texels are done one by one there,
// by as many invocations, and none waits for its neighbours' longer walks.
// One invocation for a narrow quad; BROAD: work groups for a broad one. In: footprints, flux, tangent planes, depth pyramid,
// the lists. Out: touches; of quads whose touches found no room, the list `left`.
#include "caustics/beam_cut.glsl"
#include "caustics/beam_walk.glsl"
#include "caustics/listed_quads.glsl"
#include "caustics/beam_touches.glsl"

// A narrow quad has no more. Of a broad one few invocations find more: their group walks a second time.
const int mostKept = mostGathered;
int found = 0, room = -1; // touches of the invocation so far; where they go, < 0 in the first walk
int kept[mostKept];

void visit(Quad quad, int index, Slab slab, ivec2 texel, float depth) {
    if (!mayTouch(cutAt(quad, texel))) return;
    int number = texel.y * boxSize.x + texel.x;
    if (room >= 0) touches[room + found] = ivec2(index, number);
    else if (found < mostKept) kept[found] = number;
    ++found;
}

// So many touches, of a quad's part, if they find room.
int roomFor(int count, int index, int part) {
    int first = count > 0 ? reserveTouches(count) : 0;
    if (first < 0) leaveTo(left, part * quads.x * quads.y + index);
    return first;
}

void writeKept(int index) {
    for (int i = 0; i < found; ++i) touches[room + i] = ivec2(index, kept[i]);
}

#ifdef BROAD
shared int groupFound, groupMost, groupRoom; // touches of all invocations, of that with most; where they go

void doQuad(Quad quad, int index, int part, int parts) {
    bool first = gl_LocalInvocationIndex == 0u;
    found = 0, room = -1;
    if (first) groupFound = groupMost = 0;
    barrier();
    // Twice, where some invocation could not keep what it found.
    for (int i = 0; i < 2; ++i) {
        walk(quad, index, part, parts);
        if (i == 1) break;
        int before = atomicAdd(groupFound, found);
        atomicMax(groupMost, found);
        barrier();
        if (first) groupRoom = roomFor(groupFound, index, part);
        barrier();
        if (groupRoom < 0) break;
        room = groupRoom + before;
        if (groupMost <= mostKept) {
            writeKept(index);
            break;
        }
        found = 0;
    }
    barrier(); // before the next quad counts
}
#else
void doQuad(Quad quad, int index, int part, int parts) {
    found = 0, room = -1;
    walk(quad, index, part, parts);
    room = roomFor(found, index, part);
    if (room >= 0) writeKept(index);
}
#endif

void main() { doListed(shaded); }
