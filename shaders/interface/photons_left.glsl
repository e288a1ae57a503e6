// Photons that something may be in the way of, or whose splat has many texels: where they land and what they may meet.
#pragma once
#include "interface/blocks.glsl"
const int mostShadows = 8; // triangles that are told apart
struct LeftPhoton {
    int number;
    float metres;
    int texel;   // row by row
    float parts, apart; // of its splat
    int found;          // triangles; < 0: more than these
    int spare[2];
    int triangles[mostShadows];
};
STORAGE_BLOCK(PhotonsLeft, photonsLeftBuffer) {
    uint leftGroups[3]; // to dispatch: a work group a photon
    uint leftCount;
    ENDLESS(LeftPhoton, left) // room for all of a pass
};
