// The frame of a receiver's maps: thesis 4.2.1 (see core/OrientedBox.h). Positions in m from the scene's origin.
#pragma once
#include "interface/blocks.glsl"
UNIFORM_BLOCK(BoxFrame, boxFrameBlock) {
    vec4 boxCorner; // near face, texel (0, 0)
    vec4 boxU;      // unit, right
    vec4 boxW;      // unit, down
    vec4 boxT;      // unit, along the light
    vec4 boxExtent; // along u, w, t, m; w: side of a texel, m
    ivec4 boxSize; // texels along u, w; reference planes asked for; this map's facing, + 8 for a mesh that is
                    // not closed, + 16 for one that is and that the water's surface cuts open
    vec4 facingLight;   // mean light, unit; w: faces whose normal is within this sine of being across it are steep
    vec4 boxShear;      // how depth grows along u and w on the whole, m/m: the lean of the receiver in its box
    vec4 boxGradients;  // least along u, w and greatest along u, w of any face's depth, m/m
    vec4 facingAxes[4]; // unit, across the mean light; w: 1 where there is a side map
};
