// What a tile of the water's grid is known by.
#pragma once

// Quads along a side of a tile.
const int tileQuads = 8;

// Of the rays at the corners of a tile's quads.
struct RayBounds {
    vec4 originLow, originHigh;       // m from the scene's origin
    vec4 directionLow, directionHigh; // of the unit vectors, by component
};
