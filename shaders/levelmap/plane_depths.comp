// The finest level of a plane pyramid: the depth of the reference plane that each texel belongs to.
// In: position map RG32F (level_map.frag); depth of each plane by its index, m.
// Out, RGBA32F: that depth twice, as least and greatest (1e30, -1e30: no receiver, or no light); 0, 0.
#include "interface/bindings.glsl"
#include "levelmap/box.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = positionMapUnit) uniform sampler2D positionMap;
layout(rgba32f, binding = depthPyramidImage) uniform writeonly image2D depthRange;
layout(std430, binding = planesBuffer) readonly buffer Planes { float planes[]; };

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(texel, boxSize.xy))) return;
    float plane = texelFetch(positionMap, texel, 0).y;
    vec2 range = plane < 0.0 ? vec2(1e30, -1e30) : vec2(planes[int(plane)]);
    imageStore(depthRange, texel, vec4(range, 0.0, 0.0));
}
