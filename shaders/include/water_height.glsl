// The water's surface as the picture draws it, asked by place.
#include "include/view.glsl"
layout(std430, binding = 1) readonly buffer SurfacePositions { vec4 surfacePositions[]; };

float cornerHeight(ivec2 at) {
    vec3 corner = surfacePositions[at.y * (patchQuads.x + 1) + at.x].xyz;
    return mix(viewWater.x, corner.y, rimShare((corner.xz - patchRect.xy) / patchRect.zw));
}

// y of the surface over xz, m: that of the very triangle that is drawn there (see water/WaterSurface.cpp for how quads
// are cut), or else an object's waterline and the water would part.
float waterHeight(vec2 xz) {
    vec2 at = (xz - patchRect.xy) / patchRect.zw * vec2(patchQuads.xy);
    if (any(lessThan(at, vec2(0.0))) || any(greaterThanEqual(at, vec2(patchQuads.xy)))) return viewWater.x;
    ivec2 quad = ivec2(at);
    vec2 f = at - vec2(quad);
    float a = cornerHeight(quad), b = cornerHeight(quad + ivec2(1, 0));
    float c = cornerHeight(quad + ivec2(0, 1)), d = cornerHeight(quad + ivec2(1, 1));
    if (((quad.x + quad.y) & 1) == 0) {
        if (f.x + f.y < 1.0) return a + f.x * (b - a) + f.y * (c - a);
        return d + (1.0 - f.x) * (c - d) + (1.0 - f.y) * (b - d);
    }
    if (f.x < f.y) return a + f.y * (c - a) + f.x * (d - c);
    return a + f.x * (b - a) + f.y * (d - b);
}
