// Quads that a pass leaves to a later one, in three lists: `plain`; `shaded`, which something may shade; and `wide`, the
// same that touch many texels, or more than there is room for.
#pragma once
#include "interface/blocks.glsl"
STORAGE_BLOCK(BeamLists, beamListsBuffer) {
    uvec4 work[3]; // of each list: work groups to dispatch, 1, 1; quads in it
    ENDLESS(int, listed) // room for all quads, three times
};
const int plain = 0, shaded = 1, wide = 2;
