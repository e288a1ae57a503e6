// Where light lands, ray by ray: the count that the finished maps are held against. Each beam is split into rays of
// equal flux; each ray is followed through the scene depth map to the first receiver.
// In: indices, beam origins and directions. Out: a ray: landing point (m from the scene's origin), w = number of
// the receiver, -1 for a ray that passes all of them, -2 for one that lands in what the mean light leaves dark,
// -3 for one that something above the water takes, -5 for one that passes behind an edge of what is first, at that
// edge: only the maps of single receivers know what comes then (OWN_DIRECTION).
#include "include/scene_depth.glsl"
#include "include/beam_rays.glsl"
#ifdef OWN_DIRECTION
layout(binding = 6) uniform sampler2D scenePyramid; // RGBA32F (scene_depth_range.comp)
#endif
#include "include/surface_shadow.glsl"
layout(local_size_x = 64) in;
const int steps = 96;
const int halvings = 14;
const float nothing = 1e29;

vec4 land(vec3 from, vec3 direction) {
    float reach = farthest * 1.5;
    float low = 0.0;
    vec2 atLow = beforeFirst(from);
    for (int i = 0; i < steps && low < reach; ++i) {
        // The ray leans only a little against the mean light, so most of the gap is free water.
        float leap = atLow.y > nothing ? reach / 24.0 : max(0.7 * atLow.x, reach / 400.0);
        float high = low + leap;
        vec2 atHigh = beforeFirst(from + high * direction);
        if (atHigh.x > 0.0) {
            low = high;
            atLow = atHigh;
            continue;
        }
        for (int k = 0; k < halvings; ++k) {
            float middle = 0.5 * (low + high);
            vec2 at = beforeFirst(from + middle * direction);
            if (at.x > 0.0) low = middle, atLow = at;
            else high = middle, atHigh = at;
        }
        vec3 point = from + high * direction;
        ivec2 size = textureSize(sceneDepth, 0);
        float footprint = sceneDepthTexel();
        // Slipping behind an edge is a step that halving cannot close.
        if (-atHigh.x > 8.0 * footprint) {
#ifdef OWN_DIRECTION
            vec2 edge = sceneDepthUv(entryPoint(point));
            float left = texelFetch(scenePyramid, min(ivec2(edge * vec2(size)), size - 1), 0).z;
            // Into the side of a solid, or past it.
            return vec4(point, atHigh.y - atHigh.x < left ? -2.0 : -5.0);
#else
            return vec4(point, atLow.y > nothing ? -1.0 : -2.0);
#endif
        }
        vec2 uv = sceneDepthUv(entryPoint(point));
        return vec4(point, texelFetch(sceneDepth, min(ivec2(uv * vec2(size)), size - 1), 0).y);
    }
    return vec4(from, -1.0);
}

void main() {
    int ray = int(gl_GlobalInvocationID.y * gl_NumWorkGroups.x * gl_WorkGroupSize.x + gl_GlobalInvocationID.x);
    if (ray >= rayCount) return;
    Ray r = beamRay(ray);
    landings[ray] = isLit(r.from) ? land(r.from, r.direction) : vec4(r.from, -3.0);
}
