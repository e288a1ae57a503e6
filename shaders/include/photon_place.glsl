// Where photons land on what a level map shows, and which texels around are the same surface.
#include "include/box.glsl"
#include "include/octahedral.glsl"
layout(binding = 0) uniform sampler2D positionMap; // RG32F
layout(binding = 1) uniform sampler2D diffuseMap;  // alpha: share of the mean light
layout(binding = 2) uniform sampler2D normalMap;   // RG16

// The plane of the surface in a texel: depth in m at `from` (m along u and w), and how it grows by m.
struct TexelPlane {
    float depth;
    vec2 rise;
    bool lit; // false: no receiver that takes light
};

// Steeper faces than this are followed as if they were this steep.
const float leastFacing = 0.05;

bool inMap(ivec2 texel) { return all(greaterThanEqual(texel, ivec2(0))) && all(lessThan(texel, boxSize.xy)); }

TexelPlane planeAt(ivec2 texel) {
    if (!inMap(texel)) return TexelPlane(0.0, vec2(0.0), false);
    vec2 position = texelFetch(positionMap, texel, 0).xy;
    vec3 normal = boxDirection(octahedralDecode(texelFetch(normalMap, texel, 0).xy));
    return TexelPlane(position.x, normal.xy / max(-normal.z, leastFacing), position.y >= 0.0);
}

// Metres that a texel's plane lies below a point.
float metresAbove(TexelPlane plane, ivec2 texel, vec3 q) {
    return plane.depth + dot(plane.rise, q.xy - (vec2(texel) + 0.5) * boxExtent.w) - q.z;
}

// Whether `texel` shows the surface that the plane of `landed` belongs to, `reach` texels around it.
bool sameSurface(ivec2 texel, TexelPlane plane, ivec2 landed, float reach) {
    if (!inMap(texel)) return false;
    vec2 position = texelFetch(positionMap, texel, 0).xy;
    if (position.y < 0.0) return false;
    float expected = plane.depth + dot(plane.rise, vec2(texel - landed) * boxExtent.w);
    return abs(position.x - expected) <= boxExtent.w * (1.0 + reach) * (1.0 + 0.5 * length(plane.rise));
}
