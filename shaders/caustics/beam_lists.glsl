// Leaves a quad to a later pass.
#include "interface/beam_lists.glsl"

void leaveTo(int list, int quad) {
    uint slot = atomicAdd(work[list].w, 1u);
    // The limit is what one row of groups may be; the groups there walk through the rest.
    if (slot % 64u == 0u && slot < 64u * 65535u) atomicAdd(work[list].x, 1u);
    listed[list * quads.x * quads.y + int(slot)] = quad;
}
