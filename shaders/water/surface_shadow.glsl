// What things above the water take from the light before it reaches the surface.
// R32F over the rectangle of the flat surface: metres along the light from the first thing it meets down to the
// surface; 0 where nothing is before it.
#include "interface/bindings.glsl"
#include "water/light.glsl"
layout(binding = surfaceShadowUnit) uniform sampler2D surfaceShadow;

// Where the straight light through a point at or above the level meets the flat surface.
vec3 straightFoot(vec3 point) {
    vec3 incident = incidentDirection(point);
    return point + incident * (max(point.y - waterSurface.x, 0.0) / -min(incident.y, -1e-4));
}

// The share of a light that reaches a point at or above the level, [0, 1]; `slack` in m keeps a surface from
// shading itself.
float surfaceVisibility(vec3 point, float slack) {
    if (surfaceShadowRect.z <= 0.0) return 1.0;
    vec3 foot = straightFoot(point);
    vec2 uv = (foot.xz - surfaceShadowRect.xy) / surfaceShadowRect.zw;
    if (any(lessThan(uv, vec2(0.0))) || any(greaterThan(uv, vec2(1.0)))) return 1.0;
    ivec2 size = textureSize(surfaceShadow, 0);
    float here = distance(point, foot) + slack;
    vec2 at = uv * vec2(size) - 0.5;
    vec2 base = floor(at), part = at - base;
    float lit = 0.0;
    for (int i = 0; i < 4; ++i) {
        ivec2 texel = clamp(ivec2(base) + ivec2(i & 1, i >> 1), ivec2(0), size - 1);
        float weight = ((i & 1) == 0 ? 1.0 - part.x : part.x) * (i < 2 ? 1.0 - part.y : part.y);
        if (texelFetch(surfaceShadow, texel, 0).x <= here) lit += weight;
    }
    return lit;
}

// Whether light reaches a point of the surface, for counting ray by ray.
bool isLit(vec3 surface) { return surfaceVisibility(surface, 0.0) >= 0.5; }
