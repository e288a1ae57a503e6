// Quads that a pass leaves to others: those of a plane map's or a lit floor's beams, and those that something may shade; of
// each, the narrow ones, which an invocation walks, and the broad ones, which work groups walk; and what of the shaded ones
// found no room among the touches.
#pragma once
#include "interface/blocks.glsl"
STORAGE_BLOCK(BeamLists, beamListsBuffer) {
    uvec4 work[5];       // of each list, to dispatch: work groups, how many share an entry, 1; entries in it
    ENDLESS(int, listed) // room for all quads, four times; for as many times as work groups share an entry
};
const int plain = 0, shaded = 1, broad = 2, left = 4; // narrow; add `broad` for the others
