// Rays that meet a face along the light before where they would land: such faces are edges in the scene depth map, so
// the ray is followed through the further map that shows them; and rays that passed behind an edge (landings.comp), through
// every map.
// In: position map of the further map (RG32F), beams. In and out: landings (landings.comp).
#include "include/box.glsl"
#include "include/beam_rays.glsl"
layout(local_size_x = 64) in;
layout(binding = 0) uniform sampler2D positionMap;
layout(location = 4) uniform int receiverNumber;
layout(location = 5) uniform int edgesOnly; // 1: only rays that passed behind an edge

const int steps = 64;
const int halvings = 12;
const float nothing = 1e29;

// Metres along the map's axis that the point lies before the surface; nothing where the map shows none.
float beforeSurface(vec3 point) {
    vec3 q = boxLocal(point);
    ivec2 texel = ivec2(floor(q.xy / boxExtent.w));
    if (any(lessThan(texel, ivec2(0))) || any(greaterThanEqual(texel, boxSize.xy))) return nothing;
    vec2 position = texelFetch(positionMap, texel, 0).xy;
    return position.y == -1.0 ? nothing : position.x - q.z;
}

void main() {
    int ray = int(gl_GlobalInvocationID.y * gl_NumWorkGroups.x * gl_WorkGroupSize.x + gl_GlobalInvocationID.x);
    if (ray >= rayCount) return;
    vec4 landing = landings[ray];
    if (landing.w == -3.0 || (edgesOnly != 0 && landing.w != -5.0)) return;
    Ray r = beamRay(ray);
    // A ray that lands may still lose its way within a few texels of the wall it ends at.
    float reach = landing.w == -1.0 || landing.w == -5.0 ? 1.5 * farthest : distance(r.from, landing.xyz) + 8.0 * boxExtent.w;
    float low = landing.w == -5.0 ? distance(r.from, landing.xyz) : 0.0;
    float start = low, atLow = beforeSurface(r.from + low * r.direction);
    for (int i = 1; i <= steps; ++i) {
        float high = mix(start, reach, float(i) / float(steps));
        float atHigh = beforeSurface(r.from + high * r.direction);
        bool crossed = atLow < nothing && atHigh < nothing && atLow > 0.0 && atHigh <= 0.0;
        if (crossed) {
            for (int k = 0; k < halvings; ++k) {
                float middle = 0.5 * (low + high);
                float at = beforeSurface(r.from + middle * r.direction);
                if (at > 0.0) low = middle;
                else high = middle, atHigh = at;
            }
            // A jump is an edge of the surface, not the surface.
            if (-atHigh < 4.0 * boxExtent.w) {
                landings[ray] = vec4(r.from + high * r.direction, float(receiverNumber));
                return;
            }
        }
        low = high;
        atLow = atHigh;
    }
}
