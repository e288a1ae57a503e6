// Quads that touch more texels than one invocation should walk: left as tiles to a pass of many.
#pragma once
#include "interface/blocks.glsl"
const int tileSide = 16;
// Of a tile: the quad, a number that the pass gave it, place of its first texel.
STORAGE_BLOCK(LargeBeams, largeBeamsBuffer) {
    uvec3 tileGroups; // to dispatch: a work group a tile
    int tileCount;    // asked for; those beyond the buffer's end are not in it
    ENDLESS(ivec4, tiles)
};
