// Where photons land on what a level map shows, and which texels around are the same surface.
#include "interface/bindings.glsl"
#include "levelmap/box.glsl"
#include "optics/octahedral.glsl"
layout(binding = tangentPlanesUnit) uniform sampler2D tangentPlanes; // RGBA32F (caustics/tangent_planes.comp)
layout(binding = normalMapUnit) uniform sampler2D normalMap;         // RG16

// The plane of the surface in a texel: depth at its middle, m, and how it grows by m.
struct TexelPlane {
    float depth;
    vec2 rise;
    bool there;    // false: no receiver
};

// Steeper faces than this are followed as if they were this steep.
const float leastFacing = 0.05;
const float nowhereDepth = 1e30;

bool inMap(ivec2 texel) { return all(greaterThanEqual(texel, ivec2(0))) && all(lessThan(texel, boxSize.xy)); }

TexelPlane planeAt(ivec2 texel) {
    if (!inMap(texel)) return TexelPlane(nowhereDepth, vec2(0.0), false);
    vec4 plane = texelFetch(tangentPlanes, texel, 0);
    vec2 rise = plane.yz / boxExtent.w;
    return TexelPlane(plane.x, rise / max(leastFacing * length(rise), 1.0), plane.x < nowhereDepth);
}

// Metres that a texel's plane lies below a point.
float metresAbove(TexelPlane plane, ivec2 texel, vec3 q) {
    return plane.depth + dot(plane.rise, q.xy - (vec2(texel) + 0.5) * boxExtent.w) - q.z;
}

// How far off the plane of `plane` the same surface may be, `reach` texels around where that belongs, m.
float surfaceSlack(TexelPlane plane, float reach) { return boxExtent.w * (1.0 + reach) * (1.0 + 0.5 * length(plane.rise)); }

// Whether `texel` shows the surface that the plane of `landed` belongs to, `reach` texels around it.
bool sameSurface(ivec2 texel, TexelPlane plane, ivec2 landed, float reach) {
    if (!inMap(texel)) return false;
    float depth = texelFetch(tangentPlanes, texel, 0).x;
    if (depth >= nowhereDepth) return false;
    float expected = plane.depth + dot(plane.rise, vec2(texel - landed) * boxExtent.w);
    return abs(depth - expected) <= surfaceSlack(plane, reach);
}
