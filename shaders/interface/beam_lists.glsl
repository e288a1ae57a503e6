// Quads that a pass leaves to others: those that nothing shades, and those that something may; of each, the narrow ones, of
// which an invocation walks one, and the broad ones, which work groups walk. Then what of those that may be shaded found no
// room among the touches.
#pragma once
#include "interface/blocks.glsl"
STORAGE_BLOCK(BeamLists, beamListsBuffer) {
    uvec4 work[5];       // of each list, to dispatch: work groups, how many share an entry, 1; entries in it
    ENDLESS(int, listed) // room for all quads, four times; for as many times as work groups share an entry
};
const int plain = 0, shaded = 1, broad = 2, left = 4; // narrow; add `broad` for the others
