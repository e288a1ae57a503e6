// The finest level of the scene depth pyramid.
// In: scene depth map, and where its solids are left. Out, RGBA32F: least and greatest depth at which what is hit
// first is entered, least depth at which it is left again (a sheet: where it is entered), 0; all m along the mean light, 1e30 for none.
#include "include/scene_depth.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 5) uniform sampler2D sceneSolid; // RG32F (scene_exit.frag), 0, 0: none
layout(rgba32f, binding = 0) uniform writeonly image2D depthRange;

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(texel, imageSize(depthRange)))) return;
    vec2 solid = texelFetch(sceneSolid, texel, 0).xy;
    if (solid.y <= 0.0) solid = texelFetch(sceneDepth, texel, 0).xx;
    imageStore(depthRange, texel, vec4(solid.xx, solid.y, 0.0));
}
