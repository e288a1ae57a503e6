// The camera and what it sees everything through. Positions in m from the scene's origin, radiance in W/(m² sr).
// The near side is the camera's own side of the surface, the far side the other one.
#pragma once
#include "interface/blocks.glsl"
UNIFORM_BLOCK(ViewFrame, viewFrameBlock) {
    mat4 viewProjection;
    vec4 cameraPosition; // w: 1 above the water's surface, 0 below
    vec4 ambientRadiance;
    vec4 skyRadiance;
    vec4 waterExtinction; // RGB, 1/m; w: an upper bound on m beyond the surface along a view ray to any receiver
    vec4 viewWater;       // y, m, of the flat surface that views are made by: the level, or between camera and level
                          // where the camera is in the waves; index of refraction; scale of the views through and in the surface (their margin);
                          // m that a texel is wide in a metre's distance
    vec4 deepRadiance;    // what endless water looks like
    vec4 waterRest;       // x: the level, m
    vec4 patchRect;       // x, z of a corner and extents of the moving grid, m
    ivec4 patchQuads;     // of the moving grid, in x and z
    vec4 nearSideMin, nearSideMax; // what may show in the surface by reflection, m; w of the first: 1 if there is any
    vec4 farSideMin, farSideMax;   // what may show through it, likewise
};
