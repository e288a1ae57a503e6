// Which quad touches which texel.
#pragma once
#include "interface/blocks.glsl"
STORAGE_BLOCK(BeamTouches, beamTouchesBuffer) {
    uvec3 touchGroups; // to dispatch: 64 touches each
    int touchesAsked;  // of which those that did not fit are not in it
    ivec2 touchCount;  // x: in it
    ENDLESS(ivec2, touches) // quad; texel, row by row
};
