// Leaves a quad to a later pass.
#include "interface/beam_lists.glsl"

void leaveTo(int list, int entry) {
    uint slot = atomicAdd(work[list].w, 1u), each = list < broad ? 64u : 1u;
    // The limit is what one row of groups may be; the groups there walk through the rest.
    if (slot % each == 0u && slot < each * 65535u) atomicAdd(work[list].x, 1u);
    listed[list * quads.x * quads.y + int(slot)] = entry;
}

int listedIn(int list, int slot) { return listed[list * quads.x * quads.y + slot]; }
int countIn(int list) { return int(work[list].w); }
