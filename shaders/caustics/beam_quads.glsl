// Exact beams: the quads of the water's grid, and which texels of a map their beams touch with any part of them.
#include "interface/bindings.glsl"
#include "caustics/quad_span.glsl"
layout(std430, binding = footprintsBuffer) readonly buffer Footprints { vec4 footprints[]; };
layout(std430, binding = originDepthsBuffer) readonly buffer OriginDepths { float originDepths[]; };

vec4 cornerFootprint(int vertex, out float start) {
    start = originDepths[vertex];
    return footprints[vertex];
}

// False where both beams are dark, or a ray runs across the box.
bool takesPart(inout Quad quad) {
    vec4 slopes = max(max(abs(quad.p), abs(quad.q)), max(abs(quad.r), abs(quad.s)));
    return quad.flux.x + quad.flux.y > 0.0 && max(slopes.z, slopes.w) * boxExtent.w < 1e5;
}

const float thinnest = 1.0 / 256.0; // texels
vec2 firstTexel(vec2 least) { return floor(least - thinnest); }
vec2 lastTexel(vec2 most) { return floor(most + thinnest); }

// Where a corner's ray is at depth 0 and how it moves, with depths counted from a plane that leans as the receiver does:
// of a flat receiver all are alike. False where the ray does not come through that plane from the front.
bool lean(inout vec4 corner) {
    vec2 gradient = boxShear.xy * boxExtent.w;
    precise float front = 1.0 - dot(gradient, corner.zw);
    if (front < grazing) return false;
    precise vec2 slope = corner.zw / front;
    precise vec2 at = corner.xy + slope * dot(gradient, corner.xy);
    corner = vec4(at, slope);
    return true;
}

// Whether the corner's ray may meet some face of the map from the front.
bool mayMeet(vec4 corner) {
    vec2 slope = corner.zw * boxExtent.w;
    vec2 least = min(boxGradients.xy * slope, boxGradients.zw * slope);
    return least.x + least.y < 1.0;
}

// The corners' rays with depths counted from the plane that leans.
struct Leant {
    vec4 p, q, r, s;
};

// False where some ray does not come through that plane from the front.
bool lean(Quad quad, out Leant leant) {
    leant = Leant(quad.p, quad.q, quad.r, quad.s);
    return lean(leant.p) && lean(leant.q) && lean(leant.r) && lean(leant.s);
}

// `depths`, as they are counted from the plane that leans: those that are left.
bool settle(Leant leant, out Slab slab, out vec2 depths) {
    depths = vec2(-everywhere, everywhere);
    return settle(leant.p, leant.q, leant.r, leant.s, 0.25 * boxExtent.w, slab, depths);
}
