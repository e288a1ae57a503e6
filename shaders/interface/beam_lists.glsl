// Quads that a pass leaves to a later one, in three lists: `plain`; `shaded`, which something may shade; and `wide`, the
// same that touch many texels, or more than there is room for.
layout(std430, binding = 10) buffer BeamLists {
    uvec4 work[3]; // of each list: work groups to dispatch, 1, 1; quads in it
    int listed[];  // room for all quads, three times
};
const int plain = 0, shaded = 1, wide = 2;

void leaveTo(int list, int quad) {
    uint slot = atomicAdd(work[list].w, 1u);
    // The limit is what one row of groups may be; the groups there walk through the rest.
    if (slot % 64u == 0u && slot < 64u * 65535u) atomicAdd(work[list].x, 1u);
    listed[list * quads.x * quads.y + int(slot)] = quad;
}
