// Light of beams as it passes through the water: each ray gives to one layer of each gap that it reaches the top of, in
// its middle, what it would send to the camera of each metre of a view ray there.
// In: beams, the scene depth map of the light. Out: sums of 1/sr (directional) or 1/m² (point) before strength, the water's
// scattering and extinction.
#include "interface/bindings.glsl"
#include "interface/flux_sums.glsl"
#include "godrays/godray_phase.glsl"
#include "water/photon_ray.glsl"
#include "levelmap/scene_depth.glsl"
#include "interface/shaft_gap.glsl"
#include "water/surface_shadow.glsl"
layout(std430, binding = gapsBuffer) readonly buffer Gaps { Gap gaps[]; };
layout(local_size_x = 64) in;
layout(location = cellsAcrossLocation) uniform ivec2 cellsAcross; // of a layer
layout(location = gapCountLocation) uniform int gapCount;
layout(location = stepsLocation) uniform float steps; // of the sums
layout(location = testSurfaceShadowLocation) uniform int testSurfaceShadow;

// Whether the camera may see something within `around` metres of a point.
bool mayBeSeen(vec3 point, float around) {
    vec4 clip = viewProjection * vec4(point, 1.0);
    vec2 slope = 2.0 * target.zw / target.xy; // what clip coordinates grow by in a metre across the view
    return clip.w > -around && all(lessThan(abs(clip.xy), vec2(clip.w) + around * (1.0 + slope)));
}

void deposit(int layer, vec2 at, float amount) {
    vec2 base = floor(at - 0.5), part = at - 0.5 - base;
    for (int i = 0; i < 4; ++i) {
        ivec2 cell = ivec2(base) + ivec2(i & 1, i >> 1);
        if (any(lessThan(cell, ivec2(0))) || any(greaterThanEqual(cell, cellsAcross))) continue;
        vec2 share = mix(1.0 - part, part, vec2(i & 1, i >> 1));
        addFlux((layer * cellsAcross.y + cell.y) * cellsAcross.x + cell.x, amount * share.x * share.y);
    }
}

void main() {
    int index = int(gl_GlobalInvocationID.y * gl_NumWorkGroups.x * gl_WorkGroupSize.x + gl_GlobalInvocationID.x);
    int count = subdivision * subdivision;
    if (index >= cells.x * cells.y * count) return;
    Photon ray = photonOf(index / count, index % count);
    if (testSurfaceShadow != 0) ray.flux *= surfaceVisibility(ray.from, 0.0);
    if (ray.flux <= 0.0 || ray.direction.y >= -1e-3) return;
    vec2 slope = ray.direction.xz / -ray.direction.y;
    for (int i = 0; i < gapCount; ++i) {
        vec4 rect = gaps[i].rect, depth = gaps[i].depth;
        vec3 top = vec3(ray.from.xz + slope * (ray.from.y - waterSurface.x + depth.x), waterSurface.x - depth.x).xzy;
        if (i > 0 && beforeFirst(top).x <= 0.0) return;
        vec3 point = vec3(ray.from.xz + slope * (ray.from.y - waterSurface.x + depth.y), waterSurface.x - depth.y).xzy;
        vec2 cell = rect.zw / vec2(cellsAcross);
        if (!mayBeSeen(point, 2.0 * max(cell.x, cell.y) + depth.z - depth.x)) continue;
        float spread = scatteredTowards(dot(normalize(cameraPosition.xyz - point), ray.direction));
        deposit(i, (point.xz - rect.xy) / cell, steps * ray.flux * spread / (cell.x * cell.y * -ray.direction.y));
    }
}
