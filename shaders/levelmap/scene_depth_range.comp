// The finest level of the scene depth pyramid, or (SECOND) the second solids.
// In: scene depth map, or what is first beyond its solids, and where that is left. Out, RGBA32F: least and greatest depth at
// which what is hit first is entered, least depth at which it is left again (a sheet: where it is entered), its number; SECOND, RG32F:
// where it is entered and left; all m along the mean light, 1e30 for none.
#include "include/scene_depth.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 5) uniform sampler2D sceneSolid; // RG32F (scene_exit.frag), 0, 0: none
#ifdef SECOND
layout(rg32f, binding = 0) uniform writeonly image2D depthRange;
#else
layout(rgba32f, binding = 0) uniform writeonly image2D depthRange;
#endif

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(texel, imageSize(depthRange)))) return;
    vec2 solid = texelFetch(sceneSolid, texel, 0).xy, first = texelFetch(sceneDepth, texel, 0).xy;
    if (solid.y <= 0.0) solid = first.xx;
#ifdef SECOND
    imageStore(depthRange, texel, vec4(solid, 0.0, 0.0));
#else
    imageStore(depthRange, texel, vec4(solid.xx, solid.y, trunc(first.y)));
#endif
}
