// The quads of the water's grid as one receiver's map sees them, and which of its texels they may touch. Both one-pass methods
// look for them alike (plane_beams.comp, exact_beams.comp); a pass says where a corner's ray is, which quads take part, and
// what it counts as touched.
#include "interface/bindings.glsl"
#include "levelmap/box.glsl"
#include "levelmap/depth_pyramid.glsl"
#include "caustics/beam_limits.glsl"
layout(binding = depthPyramidUnit) uniform sampler2D depthPyramid; // RGBA32F, m (levelmap/PlaneDepths.h, tangent_planes.comp)
layout(std430, binding = beamFluxBuffer) readonly buffer BeamFlux { float flux[]; };
layout(location = quadsLocation) uniform ivec2 quads; // of the water's grid

// The corners of a quad: p and q the ends of its diagonal, r and s beside it. Beams are r p q and q p s.
struct Quad {
    vec4 p, q, r, s; // footprints: texels at depth 0; texels a metre of depth
    vec4 starts;     // depth of the water's surface, m: p, q, r, s
    vec2 flux;       // of r p q, q p s
    bool even;       // how it is cut (water/WaterSurface.cpp)
};

// A corner's footprint, and the depth of its ray's start, m.
vec4 cornerFootprint(int vertex, out float start);
// Leaves out what carries no light on; false where nothing is left.
bool takesPart(inout Quad quad);
// The first and the last texel that something between two places touches; on a map's edge, no texel.
vec2 firstTexel(vec2 least);
vec2 lastTexel(vec2 most);

bool loadQuad(int index, out Quad quad) {
    ivec2 at = ivec2(index % quads.x, index / quads.x);
    int a = at.y * (quads.x + 1) + at.x, c = a + quads.x + 1;
    quad.even = ((at.x + at.y) & 1) == 0;
    int p = quad.even ? c : c + 1, q = quad.even ? a + 1 : a, r = quad.even ? a : c, s = quad.even ? c + 1 : a + 1;
    quad.p = cornerFootprint(p, quad.starts.x), quad.q = cornerFootprint(q, quad.starts.y);
    quad.r = cornerFootprint(r, quad.starts.z), quad.s = cornerFootprint(s, quad.starts.w);
    quad.flux = vec2(flux[2 * index], flux[2 * index + 1]);
    return takesPart(quad);
}

// Texels whose depths are from `from` to below `to` may be touched by the part of the quad between `low` and `high`.
struct Slab {
    float from, to;
    ivec2 low, high;
    bool far; // corners may be 64 texels from some of them
};
const float everywhere = 1e29;

// Where a corner's ray is at a depth. The same bits wherever it is asked: bounds found by depths must hold for all between.
vec2 onPlane(vec4 corner, float depth) {
    precise vec2 at = corner.xy + depth * corner.zw;
    return at;
}

// The texels of the map that four rays may touch between two depths; false if there are none.
bool spanBetween(vec4 a, vec4 b, vec4 c, vec4 d, vec2 depths, inout Slab slab) {
    vec2 p = onPlane(a, depths.x), q = onPlane(b, depths.x), r = onPlane(c, depths.x), s = onPlane(d, depths.x);
    vec2 least = min(min(p, q), min(r, s)), most = max(max(p, q), max(r, s));
    p = onPlane(a, depths.y), q = onPlane(b, depths.y), r = onPlane(c, depths.y), s = onPlane(d, depths.y);
    least = min(least, min(min(p, q), min(r, s))), most = max(most, max(max(p, q), max(r, s)));
    slab.far = any(greaterThan(most - least, vec2(60.0)));
    slab.low = ivec2(clamp(firstTexel(least), vec2(0.0), vec2(boxSize.xy)));
    slab.high = ivec2(clamp(lastTexel(most), vec2(-1.0), vec2(boxSize.xy - 1)));
    return all(lessThanEqual(slab.low, slab.high));
}

// The span over the depths that four rays find there, asked for again until it settles, or spans no more than `enough` metres.
// `depths`: those that are looked at; then those that are left.
bool settle(vec4 a, vec4 b, vec4 c, vec4 d, float enough, out Slab slab, inout vec2 depths) {
    slab.from = -everywhere, slab.to = everywhere;
    vec2 whole = texelFetch(depthPyramid, ivec2(0), textureQueryLevels(depthPyramid) - 1).xy;
    depths = vec2(max(whole.x, depths.x), min(whole.y, depths.y));
    if (depths.x > depths.y) return false;
    for (int i = 0; i < 4; ++i) {
        if (!spanBetween(a, b, c, d, depths, slab)) return false;
        if (depths.y - depths.x <= enough) return true;
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

// Light along the receiver sweeps over many texels and meets few. Its way through `height` metres is cut into so many slabs
// of depth that it sweeps about its own width in each.
const int mostSlabs = 256;
int slabsAlong(Quad quad, float height) {
    precise vec2 slope = max(max(abs(quad.p.zw), abs(quad.q.zw)), max(abs(quad.r.zw), abs(quad.s.zw)));
    precise vec2 across = max(abs(quad.q.xy - quad.p.xy), abs(quad.r.xy - quad.s.xy));
    precise float step = max(max(across.x, across.y), 6.0);
    precise float sweep = max(slope.x, slope.y) * height / step;
    return 1 << clamp(findMSB(int(min(sweep, 255.0))) + 1, 0, 8);
}

// Depths of a slab of `count` between two. The same bits wherever it is asked: a depth belongs to one slab.
vec2 slabDepths(vec2 depths, int number, int count) {
    precise vec2 within = depths.x + (depths.y - depths.x) * (vec2(float(number), float(number + 1)) / float(count));
    return vec2(number == 0 ? depths.x : within.x, number + 1 == count ? depths.y : within.y);
}
