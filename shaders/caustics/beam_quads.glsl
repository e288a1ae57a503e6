// The quads of the water's grid as one receiver's map sees them, and which of its texels they may touch.
#include "interface/bindings.glsl"
#include "levelmap/box.glsl"
#include "caustics/beam_limits.glsl"
#include "levelmap/depth_pyramid.glsl"
layout(binding = depthPyramidUnit) uniform sampler2D depthPyramid; // RGBA32F (tangent_planes.comp)
layout(std430, binding = beamFluxBuffer) readonly buffer BeamFlux { float flux[]; };
layout(std430, binding = footprintsBuffer) readonly buffer Footprints { vec4 footprints[]; };
layout(std430, binding = originDepthsBuffer) readonly buffer OriginDepths { float originDepths[]; };
layout(location = quadsLocation) uniform ivec2 quads; // of the water's grid

// The corners of a quad: p and q the ends of its diagonal, r and s beside it. Beams are r p q and q p s.
struct Quad {
    vec4 p, q, r, s; // footprints: texels at depth 0; texels a metre of depth
    vec2 flux;
    vec4 starts;     // depth of the water's surface, m: p, q, r, s
};

// False where no light goes on: both beams are dark, or a ray runs across the box.
bool loadQuad(int index, out Quad quad) {
    ivec2 at = ivec2(index % quads.x, index / quads.x);
    int a = at.y * (quads.x + 1) + at.x, c = a + quads.x + 1;
    // The diagonals alternate (water/WaterSurface.cpp).
    bool even = ((at.x + at.y) & 1) == 0;
    int p = even ? c : c + 1, q = even ? a + 1 : a, r = even ? a : c, s = even ? c + 1 : a + 1;
    quad.flux = vec2(flux[2 * index], flux[2 * index + 1]);
    quad.p = footprints[p], quad.q = footprints[q], quad.r = footprints[r], quad.s = footprints[s];
    quad.starts = vec4(originDepths[p], originDepths[q], originDepths[r], originDepths[s]);
    vec4 slopes = max(max(abs(quad.p), abs(quad.q)), max(abs(quad.r), abs(quad.s)));
    return quad.flux.x + quad.flux.y > 0.0 && max(slopes.z, slopes.w) * boxExtent.w < 1e5;
}

const float thinnest = 1.0 / 256.0; // texels

// Where a corner's ray is at depth 0 and how it moves, with depths counted from a plane that leans as the receiver does:
// of a flat receiver all are alike. False where the ray does not come through that plane from the front.
bool lean(inout vec4 corner) {
    vec2 gradient = boxShear.xy * boxExtent.w;
    float front = 1.0 - dot(gradient, corner.zw);
    if (front < grazing) return false;
    corner.zw /= front;
    corner.xy += corner.zw * dot(gradient, corner.xy);
    return true;
}

// Whether the corner's ray may meet some face of the map from the front.
bool mayMeet(vec4 corner) {
    vec2 slope = corner.zw * boxExtent.w;
    vec2 least = min(boxGradients.xy * slope, boxGradients.zw * slope);
    return least.x + least.y < 1.0;
}

// Texels whose centres lie at depths from `from` to below `to` are touched by the part of the beam between `low` and
// `high`.
struct Slab {
    float from, to;
    ivec2 low, high;
};
const float everywhere = 1e29;

// The footprint of four rays between two depths, in texels of the map; false if it lies outside.
bool footprintBetween(vec4 a, vec4 b, vec4 c, vec4 d, vec2 depths, out ivec2 low, out ivec2 high) {
    vec2 p = a.xy + depths.x * a.zw, q = b.xy + depths.x * b.zw;
    vec2 r = c.xy + depths.x * c.zw, s = d.xy + depths.x * d.zw;
    vec2 least = min(min(p, q), min(r, s)), most = max(max(p, q), max(r, s));
    float height = depths.y - depths.x;
    p += height * a.zw, q += height * b.zw, r += height * c.zw, s += height * d.zw;
    least = min(least, min(min(p, q), min(r, s))), most = max(most, max(max(p, q), max(r, s)));
    low = ivec2(clamp(floor(least - thinnest), vec2(0.0), vec2(boxSize.xy)));
    high = ivec2(clamp(floor(most + thinnest), vec2(-1.0), vec2(boxSize.xy - 1)));
    return all(lessThanEqual(low, high));
}

// The footprint over the depths that the quad finds there, asked for again until it settles. `depths`, as they are
// counted from the plane that leans: those that are left.
bool settle(vec4 a, vec4 b, vec4 c, vec4 d, out Slab slab, out vec2 depths) {
    slab.from = -everywhere, slab.to = everywhere;
    depths = texelFetch(depthPyramid, ivec2(0), textureQueryLevels(depthPyramid) - 1).xy;
    for (int i = 0; i < 4; ++i) {
        if (!footprintBetween(a, b, c, d, depths, slab.low, slab.high)) return false;
        if (depths.y - depths.x <= 0.25 * boxExtent.w) return true;
        vec2 found = depthRange(depthPyramid, slab.low, slab.high);
        found = vec2(max(found.x, depths.x), min(found.y, depths.y));
        if (found.x > found.y) return false;
        if (found == depths) return true;
        depths = found;
    }
    return true;
}

int texelsOf(Slab slab) {
    ivec2 span = slab.high - slab.low + 1;
    return span.x * span.y;
}

// Whether a settled quad is walked at once; else its many texels come from how far its light goes along the receiver.
bool isOneSlab(Slab slab, vec2 depths) { return texelsOf(slab) <= mostTexels || depths.y - depths.x <= boxExtent.w; }

// Light along the receiver may meet it anywhere: its way through the box is cut into so many slabs of depth that
// each has few texels. A power of two, so that whole runs of them can be skipped.
int slabsAlong(Quad quad) {
    vec2 slope = max(max(abs(quad.p.zw), abs(quad.q.zw)), max(abs(quad.r.zw), abs(quad.s.zw)));
    vec2 across = max(abs(quad.q.xy - quad.p.xy), abs(quad.r.xy - quad.s.xy));
    float step = max(max(across.x, across.y), 6.0);
    return 1 << clamp(findMSB(int(max(slope.x, slope.y) * boxExtent.z / step)) + 1, 0, 8);
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

// `run` slabs from `index` of `count`; false if the beam meets nothing there.
bool slabAlong(Quad quad, int index, int run, int count, out Slab slab) {
    slab.from = index == 0 ? -everywhere : boxExtent.z * float(index) / float(count);
    slab.to = index + run == count ? everywhere : boxExtent.z * float(index + run) / float(count);
    // A texel's plane reaches beyond the depth of its centre.
    vec2 steepest = min(max(abs(boxGradients.xy), abs(boxGradients.zw)), vec2(8.0));
    float reach = 0.5 * (steepest.x + steepest.y) * boxExtent.w;
    vec2 depths = boxExtent.z * vec2(float(index), float(index + run)) / float(count) + vec2(-reach, reach);
    if (!footprintBetween(quad.p, quad.q, quad.r, quad.s, depths, slab.low, slab.high)) return false;
    vec2 surface = depthRange(depthPyramid, slab.low, slab.high), beam = distanceBetween(quad, depths);
    // Where a texel is cut across the box's axis, the beam is within half of it of the surface.
    float margin = 0.5 * (abs(boxShear.x) + abs(boxShear.y)) * boxExtent.w;
    return beam.x - margin <= surface.y && beam.y + margin >= surface.x;
}
