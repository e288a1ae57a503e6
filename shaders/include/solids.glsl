// Which solid a place of the scene depth map is asked for.
#include "include/scene_depth.glsl"
layout(location = 5) uniform int secondSolid;           // 1: of what lies beyond the first solid alone
layout(binding = 6) uniform sampler2D scenePyramid; // RGBA32F (scene_depth_range.comp), then of the first solid

// m along the mean light; up to there all belongs to the first solid, and none of it counts for the second.
float firstSolidEnds(ivec2 place) {
    return secondSolid != 0 ? texelFetch(scenePyramid, place, 0).z + 0.1 * sceneDepthTexel() : -1e30;
}
