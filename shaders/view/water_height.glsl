// The water's surface as the picture draws it, asked by place.
#include "interface/bindings.glsl"
#include "view/view.glsl"
layout(std430, binding = positionsBuffer) readonly buffer SurfacePositions { vec4 surfacePositions[]; };

float cornerHeight(ivec2 at) {
    vec3 corner = surfacePositions[at.y * (patchQuads.x + 1) + at.x].xyz;
    return mix(waterRest.x, corner.y, rimShare((corner.xz - patchRect.xy) / patchRect.zw));
}

// y of the surface over xz, m: that of the very triangle that is drawn there, or else an object's waterline and the
// water would part.
float waterHeight(vec2 xz) {
    vec2 at = (xz - patchRect.xy) / patchRect.zw * vec2(patchQuads.xy);
    if (any(lessThan(at, vec2(0.0))) || any(greaterThanEqual(at, vec2(patchQuads.xy)))) return waterRest.x;
    ivec2 quad = ivec2(at);
    bool even = ((quad.x + quad.y) & 1) == 0;
    return quadHeight(even, at - vec2(quad), cornerHeight(quad), cornerHeight(quad + ivec2(1, 0)), cornerHeight(quad + ivec2(0, 1)), cornerHeight(quad + ivec2(1, 1)));
}
