// The camera that light in the water is drawn for, and what scatters it. Positions in m from the scene's origin.
#pragma once
#include "interface/blocks.glsl"
UNIFORM_BLOCK(GodrayFrame, godrayFrameBlock) {
    mat4 viewProjection; // depth from 1 near by to 0 far away, w the metres along the view
    vec4 cameraPosition; // w: nearest w that is drawn, m
    vec4 target;         // pixels in x and y; pixels that a metre fills in x and y at a metre's distance
    vec4 strength;       // of the light, W per unit of flux; w: 0 Henyey and Greenstein, 1 Schlick
    vec4 scattering;     // RGB, 1/m; w: anisotropy
    vec4 extinctionPerMetre; // RGB
};
