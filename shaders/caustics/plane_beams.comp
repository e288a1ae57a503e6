// The level map in one pass (thesis 4.4 and 4.5 with nothing drawn): each beam finds the planes that it can meet, walks
// the texels there, and gives its irradiance to those whose centre it covers on the texel's own plane.
// One invocation for the two beams of a quad of the water's grid, a work group for a tile of quads. In: beams, planes of the
// texels (levelmap/PlaneDepths.h), normal map; with PATHS, for what happens to light on its way, position map and
// surface shadow. Out: flux sums, one channel or three (COLOURED), of irradiance times the area of a texel, as if the
// whole mean light reached it. LARGE: the tiles of quads that touch many texels, which the pass over all quads left.
#include "interface/bindings.glsl"
#include "caustics/beam_limits.glsl"
#include "levelmap/depth_pyramid.glsl"
#include "caustics/footprint.glsl"
#include "caustics/beam_deposit.glsl"
#include "caustics/large_beams.glsl"
#include "optics/octahedral.glsl"
#include "optics/optics.glsl"
#include "caustics/texel_coverage.glsl"
#ifndef LARGE
#include "caustics/tile_quads.glsl"
#endif
#ifdef PATHS
#include "water/surface_shadow.glsl"
layout(binding = positionMapUnit) uniform sampler2D positionMap; // RG32F
#endif
layout(local_size_x = 64) in;
const int settled = -1;     // of a tile: the quad was walked as one slab
const vec2 everyDepth = vec2(-1e30, 1e30);
layout(binding = depthPyramidUnit) uniform sampler2D planeDepths; // RGBA32F, m
layout(binding = normalMapUnit) uniform sampler2D normalMap;      // RG16
layout(std430, binding = beamOriginsBuffer) readonly buffer BeamOrigins { vec4 origins[]; };
layout(std430, binding = beamDirectionsBuffer) readonly buffer BeamDirections { vec4 directions[]; };
layout(std430, binding = beamFluxBuffer) readonly buffer BeamFlux { float flux[]; };
layout(location = quadsLocation) uniform ivec2 quads;               // of the water's grid
layout(location = stepsPerFluxLocation) uniform float stepsPerFlux; // of the sums
layout(location = depthLimitsLocation) uniform vec2 depthLimits;    // planes outside of these are left out, m
layout(location = extinctionPerMetreLocation) uniform vec3 extinctionPerMetre;
layout(location = testSurfaceShadowLocation) uniform int testSurfaceShadow; // 0: nothing stands out of the water

// The corners of a quad: p and q the ends of its diagonal, r and s beside it. Beams are r p q and q p s.
struct Quad {
    vec4 p, q, r, s;  // footprints
    vec4 starts;      // depth of the water's surface, m: p, q, r, s
    vec2 flux;        // of r p q, q p s
    bool even;        // how it is cut (water/WaterSurface.cpp)
};

vec4 cornerFootprint(int vertex, out float start) {
    vec3 origin = boxLocal(origins[vertex].xyz);
    start = origin.z;
    return rayFootprint(origin, boxDirection(directions[vertex].xyz));
}

// False where no light goes on.
bool loadQuad(ivec2 at, out Quad quad) {
    int index = at.y * quads.x + at.x;
    int a = at.y * (quads.x + 1) + at.x, c = a + quads.x + 1;
    quad.even = ((at.x + at.y) & 1) == 0;
    int p = quad.even ? c : c + 1, q = quad.even ? a + 1 : a, r = quad.even ? a : c, s = quad.even ? c + 1 : a + 1;
    quad.p = cornerFootprint(p, quad.starts.x), quad.q = cornerFootprint(q, quad.starts.y);
    quad.r = cornerFootprint(r, quad.starts.z), quad.s = cornerFootprint(s, quad.starts.w);
    quad.flux.x = meetsPlanes(quad.r, quad.p, quad.q) ? flux[2 * index] : 0.0;
    quad.flux.y = meetsPlanes(quad.q, quad.p, quad.s) ? flux[2 * index + 1] : 0.0;
    // A beam without light takes no part in where the quad is looked for.
    if (!(quad.flux.x > 0.0)) quad.r = quad.p;
    if (!(quad.flux.y > 0.0)) quad.s = quad.p;
    return quad.flux.x > 0.0 || quad.flux.y > 0.0;
}

vec2 onPlane(vec4 corner, float depth) {
    // The same bits wherever it is asked: bounds found by depths must hold for all between.
    precise vec2 at = corner.xy + depth * corner.zw;
    return at;
}

// Texels whose centres the quad may cover.
struct Walk {
    ivec2 low, high;
    bool far; // corners may be 64 texels from some of them
};
const float margin = 1.0 / 64.0; // texels: corners snap by less

// Texels that the quad may cover between two depths; false if there are none in the map.
bool walkBetween(Quad quad, vec2 depths, out Walk walk) {
    vec2 p = onPlane(quad.p, depths.x), q = onPlane(quad.q, depths.x), r = onPlane(quad.r, depths.x), s = onPlane(quad.s, depths.x);
    vec2 least = min(min(p, q), min(r, s)), most = max(max(p, q), max(r, s));
    p = onPlane(quad.p, depths.y), q = onPlane(quad.q, depths.y), r = onPlane(quad.r, depths.y), s = onPlane(quad.s, depths.y);
    least = min(least, min(min(p, q), min(r, s))), most = max(most, max(max(p, q), max(r, s)));
    walk.far = any(greaterThan(most - least, vec2(60.0)));
    walk.low = ivec2(clamp(ceil(least - 0.5 - margin), vec2(0.0), vec2(boxSize.xy)));
    walk.high = ivec2(clamp(floor(most - 0.5 + margin), vec2(-1.0), vec2(boxSize.xy - 1)));
    return all(lessThanEqual(walk.low, walk.high));
}

// The same over the planes that are found there, asked for again until it settles. `depths`: of those planes.
bool findWalk(Quad quad, out Walk walk, out vec2 depths) {
    depths = texelFetch(planeDepths, ivec2(0), textureQueryLevels(planeDepths) - 1).xy;
    depths = vec2(max(depths.x, depthLimits.x), min(depths.y, depthLimits.y));
    if (depths.x > depths.y) return false;
    for (int i = 0; i < 4; ++i) {
        if (!walkBetween(quad, depths, walk)) return false;
        if (depths.x == depths.y) return true;
        vec2 found = depthRange(planeDepths, walk.low, walk.high);
        found = vec2(max(found.x, depths.x), min(found.y, depths.y));
        if (found.x > found.y) return false;
        if (found == depths) return true;
        depths = found;
    }
    return true;
}

int texelsOf(Walk walk) {
    ivec2 size = walk.high - walk.low + 1;
    return size.x * size.y;
}

// Light along the receiver sweeps over many texels and meets few. The planes that it may meet are cut into so many slabs
// that it sweeps about its own width in each; a power of two, so that whole runs of them can be skipped.
int slabsAlong(Quad quad, vec2 depths) {
    precise vec2 slope = max(max(abs(quad.p.zw), abs(quad.q.zw)), max(abs(quad.r.zw), abs(quad.s.zw)));
    precise vec2 across = max(abs(quad.q.xy - quad.p.xy), abs(quad.r.xy - quad.s.xy));
    precise float step = max(max(across.x, across.y), 6.0);
    precise float sweep = max(slope.x, slope.y) * (depths.y - depths.x) / step;
    return 1 << clamp(findMSB(int(min(sweep, 255.0))) + 1, 0, 8);
}

// Depths of `run` slabs from `index` of `count`. The same bits wherever it is asked: a plane belongs to one slab.
vec2 slabDepths(vec2 depths, int index, int run, int count) {
    precise vec2 within = depths.x + (depths.y - depths.x) * (vec2(float(index), float(index + run)) / float(count));
    return vec2(index == 0 ? depths.x : within.x, index + run == count ? depths.y : within.y);
}

// False if the beam meets nothing in the slab.
bool walkSlab(Quad quad, vec2 slab, out Walk walk) {
    if (!walkBetween(quad, slab, walk)) return false;
    vec2 found = depthRange(planeDepths, walk.low, walk.high);
    return found.x <= slab.y && found.y >= slab.x;
}

// Shares of three corners, given from a place, in what lies between them at that place.
vec3 weightsOf(vec2 a, vec2 b, vec2 c) {
    vec3 areas = vec3(cross2(b, c), cross2(c, a), cross2(a, b));
    if (areas.x + areas.y + areas.z < 0.0) areas = -areas;
    areas = max(areas, 0.0);
    float sum = areas.x + areas.y + areas.z;
    return sum > 0.0 ? areas / sum : vec3(1.0 / 3.0);
}

// Irradiance times the area of a texel that one beam gives a texel at `texel` on the plane at `depth`, by channel, as flux:
// eq. 4-18 with Fresnel, extinction along the beam, and the receiver's own cosine.
vec3 beamFlux(vec4 a, vec4 b, vec4 c, vec3 starts, float flux, ivec2 texel, float depth) {
    vec2 centre = vec2(texel) + 0.5;
    vec3 weights = weightsOf(onPlane(a, depth) - centre, onPlane(b, depth) - centre, onPlane(c, depth) - centre);
    // The beam's direction over its component along the axis: -n·t / |t·V| of physics is -n·along.
    vec3 along = vec3((weights.x * a.zw + weights.y * b.zw + weights.z * c.zw) * boxExtent.w, 1.0);
    vec3 normal = boxDirection(octahedralDecode(texelFetch(normalMap, texel, 0).xy));
    float amount = fluxPerTexel(crossSection(a, b, c), flux, depth) * max(-dot(normal, along), 0.0);
#ifdef PATHS
    float start = dot(weights, starts);
    float lit = 1.0;
    if (testSurfaceShadow != 0) {
        vec2 from = centre * boxExtent.w - along.xy * (depth - start);
        lit = surfaceVisibility(boxPoint(vec3(from, start)), 0.0);
    }
    float metres = (texelFetch(positionMap, texel, 0).x - start) * length(along);
    return lit * amount * extinction(extinctionPerMetre, metres);
#else
    return vec3(amount);
#endif
}

// `from`: planes above it are another slab's.
void touch(Quad quad, bool far, ivec2 texel, float from, float to) {
    float depth = texelFetch(planeDepths, texel, 0).x;
    if (depth < depthLimits.x || depth > depthLimits.y || depth < from || depth >= to) return;
    vec2 centre = vec2(texel) + 0.5;
    Corners corners = Corners(snapped(onPlane(quad.p, depth) - centre), snapped(onPlane(quad.q, depth) - centre),
                              snapped(onPlane(quad.r, depth) - centre), snapped(onPlane(quad.s, depth) - centre));
    bvec2 covers = covering(corners, far);
    if (!covers.x && !covers.y) return;
    vec3 sum = vec3(0.0);
    // Corners in the order that the water's triangles have, so that areas round as those of the drawn form.
    if (covers.x && quad.flux.x > 0.0)
        sum += beamFlux(quad.even ? quad.r : quad.q, quad.even ? quad.p : quad.r, quad.even ? quad.q : quad.p,
                        quad.even ? quad.starts.zxy : quad.starts.yzx, quad.flux.x, texel, depth);
    if (covers.y && quad.flux.y > 0.0)
        sum += beamFlux(quad.q, quad.p, quad.s, quad.starts.yxw, quad.flux.y, texel, depth);
    deposit(texel, sum * stepsPerFlux);
}

#ifdef LARGE
// One work group a tile.
bool findTile(ivec4 tile, Quad quad, out Walk walk, out vec2 slab) {
    vec2 depths;
    slab = everyDepth;
    if (!findWalk(quad, walk, depths)) return false;
    if (tile.y < 0) return true;
    int count = slabsAlong(quad, depths);
    slab = slabDepths(depths, tile.y, 1, count);
    if (!walkSlab(quad, slab, walk)) return false;
    if (tile.y == count - 1) slab.y = everyDepth.y;
    return true;
}

void main() {
    int count = min(tileCount, tiles.length());
    for (int item = int(gl_WorkGroupID.x); item < count; item += int(gl_NumWorkGroups.x)) {
        ivec4 tile = tiles[item];
        Quad quad;
        Walk walk;
        vec2 slab;
        if (tile.x < 0 || !loadQuad(ivec2(tile.x % quads.x, tile.x / quads.x), quad) || !findTile(tile, quad, walk, slab)) continue;
        for (int i = int(gl_LocalInvocationIndex); i < tileSide * tileSide; i += int(gl_WorkGroupSize.x)) {
            ivec2 texel = tile.zw + ivec2(i % tileSide, i / tileSide);
            if (all(lessThanEqual(texel, walk.high))) touch(quad, walk.far, texel, slab.x, slab.y);
        }
    }
}
#else
void walkTexels(Quad quad, int index, int number, Walk walk, vec2 slab) {
    int count = texelsOf(walk);
    if (count > mostTexels && leaveToMany(index, number, walk.low, walk.high)) return;
    ivec2 texel = walk.low;
    for (int i = 0; i < count; ++i) {
        touch(quad, walk.far, texel, slab.x, slab.y);
        if (++texel.x > walk.high.x) texel = ivec2(walk.low.x, texel.y + 1);
    }
}

void walkSlabs(Quad quad, int index, vec2 depths) {
    int count = slabsAlong(quad, depths), run = count;
    for (int i = 0; i < count;) {
        Walk walk;
        vec2 slab = slabDepths(depths, i, run, count);
        bool met = walkSlab(quad, slab, walk);
        if (met && run > 1) {
            run /= 2;
            continue;
        }
        if (i + run == count) slab.y = everyDepth.y;
        if (met) walkTexels(quad, index, i, walk, slab);
        i += run;
        run = i & -i;
    }
}

void main() {
    ivec2 at;
    Quad quad;
    Walk walk;
    vec2 depths;
    if (!workQuad(quads, at) || !loadQuad(at, quad) || !findWalk(quad, walk, depths)) return;
    int index = at.y * quads.x + at.x;
    if (texelsOf(walk) <= mostTexels || depths.x == depths.y)
        walkTexels(quad, index, settled, walk, everyDepth);
    else
        walkSlabs(quad, index, depths);
}
#endif
