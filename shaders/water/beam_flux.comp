// What each water triangle takes from the light, after Fresnel: in m² for a directional light (W per W/m²), in sr
// for a point light (W per W/sr; what a spot leaves out counts less). Flux goes by the triangle's own face; the vertex normals only bend the rays.
// In: vertex indices, beam origins. Out, a triangle: flux as if nothing stood out of the water; the share of it that
// things above the water leave.
#include "interface/bindings.glsl"
#include "water/surface_shadow.glsl"
#include "water/triangle.glsl"
layout(local_size_x = 64) in;
layout(std430, binding = indicesBuffer) readonly buffer Indices { uint indices[]; };
layout(std430, binding = beamOriginsBuffer) readonly buffer BeamOrigins { vec4 origins[]; };
layout(std430, binding = beamFluxBuffer) writeonly buffer BeamFlux { float flux[]; };
layout(std430, binding = beamLitBuffer) writeonly buffer BeamLit { float lit[]; };
layout(location = triangleCountLocation) uniform int triangleCount;

// As atan(y, x), which drivers have to a few digits only: one takes 2e-5 from small angles. Halved four times by
// tan(a / 2) = y / (x + length), what is left of any angle is small enough for its series.
float angleOf(float y, float x) {
    float t = y / (x + length(vec2(x, y)));
    for (int i = 0; i < 3; ++i) t /= 1.0 + sqrt(1.0 + t * t);
    float s = t * t;
    return 16.0 * t * (1.0 - s * (1.0 / 3.0 - s * (1.0 / 5.0 - s * (1.0 / 7.0 - s * (1.0 / 9.0)))));
}

// Solid angle of a triangle seen from the origin, sr (van Oosterom and Strackee 1983); negative from behind.
float solidAngle(vec3 a, vec3 b, vec3 c) {
    float la = length(a), lb = length(b), lc = length(c);
    // The triple product from edges: as from the corners, but it keeps its digits when the triangle is small.
    float triple = dot(a, cross(b - a, c - a));
    float denominator = la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb;
    return triple == 0.0 ? 0.0 : -2.0 * angleOf(triple, denominator);
}

void main() {
    uint index = gl_GlobalInvocationID.y * gl_NumWorkGroups.x * gl_WorkGroupSize.x + gl_GlobalInvocationID.x;
    if (index >= uint(triangleCount)) return;
    vec4 a = origins[indices[3 * index]], b = origins[indices[3 * index + 1]], c = origins[indices[3 * index + 2]];
    float seen;
    if (isPointLight()) {
        vec3 light = lightPosition.xyz;
        seen = solidAngle(a.xyz - light, b.xyz - light, c.xyz - light);
    } else {
        seen = -0.5 * dot(cross(b.xyz - a.xyz, c.xyz - a.xyz), lightDirection.xyz);
    }
    float within = 1.0;
    if (lightCone.y > -1.0) {
        within = 0.0;
        for (int i = 0; i < raysPerBeam; ++i) {
            vec3 w = trianglePoint(i);
            within += intensityShare(w.x * a.xyz + w.y * b.xyz + w.z * c.xyz) / float(raysPerBeam);
        }
    }
    flux[index] = max(seen, 0.0) * (a.w + b.w + c.w) / 3.0 * within;
    float share = 1.0;
    if (surfaceShadowRect.z > 0.0) {
        share = 0.0;
        for (int i = 0; i < raysPerBeam; ++i) {
            vec3 w = trianglePoint(i);
            if (isLit(w.x * a.xyz + w.y * b.xyz + w.z * c.xyz)) share += 1.0 / float(raysPerBeam);
        }
    }
    lit[index] = share;
}
