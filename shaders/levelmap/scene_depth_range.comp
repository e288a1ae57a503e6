// The finest level of the scene depth pyramid.
// In: scene depth map, scene exit map. Out, RGBA32F: least and greatest depth of what is hit first, least depth at
// which it is left again, 0; all m along the mean light, 1e30 for none.
#include "include/scene_depth.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 5) uniform sampler2D sceneExit;
layout(rgba32f, binding = 0) uniform writeonly image2D depthRange;

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(texel, imageSize(depthRange)))) return;
    float first = texelFetch(sceneDepth, texel, 0).x;
    imageStore(depthRange, texel, vec4(first, first, max(first, texelFetch(sceneExit, texel, 0).x), 0.0));
}
