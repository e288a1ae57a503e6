// One light over flat water: the mean light. Positions in m from the scene's origin.
#pragma once
#include "interface/blocks.glsl"
UNIFORM_BLOCK(LightFrame, lightFrameBlock) {
    vec4 lightPosition;   // xyz; w: 0 directional, 1 point
    vec4 lightDirection;  // unit; directional: the way light travels; spot: its axis
    vec4 lightRefracted;  // directional: unit, the same below flat water
    vec4 sceneDepthRect;  // what the scene depth map covers of the flat surface: x, z of its corner, extents, m
    vec4 waterSurface;    // level m; index of refraction
    vec4 surfaceShadowRect; // what the surface shadow map covers of it, likewise; extent 0: nothing is above the water
    vec4 lightCone;       // spot: cosines of the inner and the outer angle; any other light: -2, -3, which all lie within
};
