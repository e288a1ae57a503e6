// What a beam is cut with at each texel: the receiver's own tangent plane there.
// In: position map RG32F, normal map RG16 (level_map.frag).
// Out 0, RGBA32F: depth of the surface at the texel's centre, m (1e30: no receiver); how that depth grows by a texel
//        to the right and down, m; 0.
// Out 1, RGBA32F, the finest level of the depth pyramid: least and greatest depth of the plane within the texel, less
//        what the receiver leans (boxShear), m (1e30, -1e30: no receiver); 0, 0.
#include "include/box.glsl"
#include "include/octahedral.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0) uniform sampler2D positionMap;
layout(binding = 2) uniform sampler2D normalMap;
layout(rgba32f, binding = 0) uniform writeonly image2D tangentPlanes;
layout(rgba32f, binding = 1) uniform writeonly image2D depthRange;

// A face steeper than this against the map has its light from its neighbours: a texel then spans 1000 of its widths.
const float leastFacing = 1e-3;

vec3 normalOf(ivec2 texel) { return octahedralDecode(texelFetch(normalMap, texel, 0).xy); }

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(texel, boxSize.xy))) return;
    vec2 position = texelFetch(positionMap, texel, 0).xy;
    if (position.y == -1.0 || position.y == -3.0) {
        imageStore(tangentPlanes, texel, vec4(1e30, 0.0, 0.0, 0.0));
        imageStore(depthRange, texel, vec4(1e30, -1e30, 0.0, 0.0));
        return;
    }
    vec3 normal = boxDirection(normalOf(texel));
    vec2 rise = normal.xy * (boxExtent.w / max(-normal.z, leastFacing));
    // What the normal's 16 bits cannot tell from none is none: floors across the light stay exactly so.
    rise *= step(vec2(1e-4 * boxExtent.w), abs(rise));
    vec2 lean = boxShear.xy * boxExtent.w, beside = abs(rise - lean);
    float reach = min(0.5 * (beside.x + beside.y), boxExtent.z);
    float upright = position.x - dot(lean, vec2(texel) + 0.5);
    imageStore(tangentPlanes, texel, vec4(position.x, rise, 0.0));
    imageStore(depthRange, texel, vec4(upright - reach, upright + reach, 0.0, 0.0));
}
