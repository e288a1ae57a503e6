// Exact beams: the walk over the texels that a quad may touch.
#include "caustics/beam_cut.glsl"
#include "caustics/quad_walk.glsl"

float depthOf(ivec2 texel) { return texelFetch(tangentPlanes, texel, 0).x; }

// Whether a settled quad is walked at once; else its many texels come from how far its light goes along the receiver.
bool isOneSlab(Slab slab, vec2 depths) { return texelsOf(slab) <= mostTexels || depths.y - depths.x <= boxExtent.w; }

Place placeOf(Quad quad) {
    Place place = nowhere();
    Leant leant;
    bool leans = lean(quad, leant);
    if (leans && !settle(leant, place.slab, place.depths)) return place;
    place.settled = leans && isOneSlab(place.slab, place.depths);
    if (!place.settled) place.depths = vec2(0.0, boxExtent.z);
    place.slabs = place.settled ? 1 : slabsAlong(quad, boxExtent.z);
    return place;
}

// Least and greatest depth of the beam between two depths, less what the receiver leans: its distance from a flat one.
vec2 distanceBetween(Quad quad, vec2 depths) {
    vec2 gradient = boxShear.xy * boxExtent.w;
    vec4 at = vec4(dot(gradient, quad.p.xy), dot(gradient, quad.q.xy), dot(gradient, quad.r.xy), dot(gradient, quad.s.xy));
    vec4 front = 1.0 - vec4(dot(gradient, quad.p.zw), dot(gradient, quad.q.zw), dot(gradient, quad.r.zw), dot(gradient, quad.s.zw));
    vec4 u = depths.x * front - at, v = depths.y * front - at;
    vec4 least = min(u, v), most = max(u, v);
    return vec2(min(min(least.x, least.y), min(least.z, least.w)), max(max(most.x, most.y), max(most.z, most.w)));
}

// Of the box's height, where light runs along the receiver.
bool slabAlong(Quad quad, vec2 height, int number, int count, out Slab slab) {
    vec2 depths = slabDepths(height, number, count);
    slab.from = number == 0 ? -everywhere : depths.x;
    slab.to = number + 1 == count ? everywhere : depths.y;
    // A texel's plane reaches beyond the depth of its centre.
    vec2 steepest = min(max(abs(boxGradients.xy), abs(boxGradients.zw)), vec2(8.0));
    float reach = 0.5 * (steepest.x + steepest.y) * boxExtent.w;
    depths += vec2(-reach, reach);
    if (!spanBetween(quad.p, quad.q, quad.r, quad.s, depths, slab)) return false;
    vec2 surface = depthRange(depthPyramid, slab.low, slab.high), beam = distanceBetween(quad, depths);
    // Where a texel is cut across the box's axis, the beam is within half of it of the surface.
    float margin = 0.5 * (abs(boxShear.x) + abs(boxShear.y)) * boxExtent.w;
    return beam.x - margin <= surface.y && beam.y + margin >= surface.x;
}
