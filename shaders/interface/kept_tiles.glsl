// The tiles of the water's grid that may send a beam to a map: filled by cull_tiles.comp.
#pragma once
#include "interface/blocks.glsl"
STORAGE_BLOCK(Kept, keptTilesBuffer) {
    uint keptGroups[3]; // to dispatch: rows of 65,535 and how many rows
    uint keptTiles;
    uint keptBeams;
    ENDLESS(uint, kept)
};
