// Who the mean light hits first: the scene depth map of a light.
// RG32F over the rectangle of the flat surface where the light enters: metres of water from there to the first
// receiver along the mean light (1e30: none), and that receiver's number, and a half if
// its face is met from behind.
#include "interface/bindings.glsl"
#include "water/light.glsl"
layout(binding = sceneDepthUnit) uniform sampler2D sceneDepth;

// Metres along the mean light from `entry` to the plane through `point` with `normal`; to the point itself where
// the plane runs along the light.
float distanceToPlane(vec3 entry, vec3 direction, vec3 point, vec3 normal) {
    float along = dot(normal, direction);
    if (abs(along) < 0.05) return dot(point - entry, direction);
    return dot(normal, point - entry) / along;
}

// The longer side of a texel of the map, m.
float sceneDepthTexel() {
    vec2 texel = sceneDepthRect.zw / vec2(textureSize(sceneDepth, 0));
    return max(texel.x, texel.y);
}

// x: metres that the point lies before what the mean light through it hits first; y: metres to that hit.
vec2 beforeFirst(vec3 point) {
    vec3 entry = entryPoint(point);
    vec2 uv = sceneDepthUv(entry);
    if (any(lessThan(uv, vec2(0.0))) || any(greaterThan(uv, vec2(1.0)))) return vec2(1e30);
    ivec2 size = textureSize(sceneDepth, 0);
    float first = texelFetch(sceneDepth, min(ivec2(uv * vec2(size)), size - 1), 0).x;
    return vec2(first - length(point - entry) * sign(waterSurface.x - point.y), first);
}

// The share of the mean light that reaches `point`, [0, 1]: the four nearest texels of the map, each asked whether
// something lies before the point's tangent plane along its own ray, weighted bilinearly. The plane takes the
// surface's slope out of the comparison; what remains is its curvature, and for the receiver itself
// (`receiverNumber`) also the limits of its own map.
float meanVisibility(vec3 point, vec3 normal, int receiverNumber) {
    vec3 entry = entryPoint(point);
    ivec2 size = textureSize(sceneDepth, 0);
    vec2 at = sceneDepthUv(entry) * vec2(size) - 0.5;
    vec2 base = floor(at), part = at - base;
    float footprint = sceneDepthTexel();
    float lit = 0.0;
    for (int i = 0; i < 4; ++i) {
        ivec2 texel = clamp(ivec2(base) + ivec2(i & 1, i >> 1), ivec2(0), size - 1);
        vec3 from = sceneDepthEntry((vec2(texel) + 0.5) / vec2(size));
        vec3 direction = meanDirection(from);
        float here = distanceToPlane(from, direction, point, normal);
        vec2 first = texelFetch(sceneDepth, texel, 0).xy;
        bool itself = int(first.y) == receiverNumber;
        float slack = footprint * (itself ? 6.0 : 1.0);
        float weight = ((i & 1) == 0 ? 1.0 - part.x : part.x) * (i < 2 ? 1.0 - part.y : part.y);
        if (first.x >= here - slack) lit += weight;
    }
    return lit;
}
