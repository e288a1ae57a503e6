// Exact beams: each texel that a beam touches takes the share of its flux that the texel's part of the beam holds, cut
// at the texel's own tangent plane (physics.md, point 5: exact on flat faces, and free of 1/area at a focus).
// One invocation for the two beams of a quad of the water's grid. In: footprints (footprints.comp), flux, tangent
// planes, depth pyramid. Out: flux sums, one channel or three (COLOURED). PATHS: also what happens to light on its way:
// extinction, what is before the receiver, what stands out of the water. LARGE: the tiles of the quads that touch many
// texels, which the pass over all quads left.
#include "include/beam_area.glsl"
#include "include/box.glsl"
#include "include/depth_pyramid.glsl"
#include "include/flux_sums.glsl"
#ifdef PATHS
#include "include/occlusion.glsl"
#include "include/octahedral.glsl"
#include "include/surface_shadow.glsl"
layout(binding = 7) uniform sampler2D normalMap;      // RG16
#endif
#include "include/optics.glsl"
layout(local_size_x = 64) in;
layout(binding = 0) uniform sampler2D tangentPlanes;  // RGBA32F (tangent_planes.comp)
layout(binding = 2) uniform sampler2D depthPyramid;   // RG32F, m
layout(std430, binding = 5) readonly buffer BeamFlux { float flux[]; };
layout(std430, binding = 6) readonly buffer Footprints { vec4 footprints[]; };
layout(std430, binding = 7) readonly buffer OriginDepths { float originDepths[]; };
layout(location = 0) uniform ivec2 quads;             // of the water's grid
layout(location = 1) uniform float stepsPerFlux;      // of the sums
layout(location = 2) uniform vec3 extinctionPerMetre;
layout(location = 3) uniform float metresBefore;      // of water that every beam crosses at least; its loss is left out
layout(location = 4) uniform int testOcclusion;       // 0: nothing can be before the receiver
layout(location = 6) uniform int receiverNumber;
layout(location = 5) uniform int testSurfaceShadow;   // 0: nothing stands out of the water

// The corners of a quad: p and q the ends of its diagonal, r and s beside it. Beams are r p q and q p s.
struct Quad {
    vec4 p, q, r, s; // footprints: texels at depth 0; texels a metre of depth
    vec2 flux;
#ifdef PATHS
    vec4 starts;     // depth of the water's surface, m: p, q, r, s
#endif
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
#ifdef PATHS
    quad.starts = vec4(originDepths[p], originDepths[q], originDepths[r], originDepths[s]);
#endif
    vec4 slopes = max(max(abs(quad.p), abs(quad.q)), max(abs(quad.r), abs(quad.s)));
    return quad.flux.x + quad.flux.y > 0.0 && max(slopes.z, slopes.w) * boxExtent.w < 1e5;
}

const float thinnest = 1.0 / 256.0; // texels

// Light that makes less than this of -n·t, by the part that does not depend on how steep the face is, runs along it.
const float grazing = 0.02;

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

// The footprint over the depths that the quad finds there, asked for again until it settles.
bool settle(Quad quad, vec4 a, vec4 b, vec4 c, vec4 d, out Slab slab) {
    slab.from = -everywhere, slab.to = everywhere;
    vec2 depths = texelFetch(depthPyramid, ivec2(0), textureQueryLevels(depthPyramid) - 1).xy;
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

// Light along the receiver may meet it anywhere: its way through the box is cut into so many slabs of depth that
// each has few texels. A power of two, so that whole runs of them can be passed over.
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

// The quad's corners on one plane, in texels from the corner of the texel.
struct Cut {
    vec2 p, q, r, s;
    float upper, lower; // areas of r p q and q p s
};

// Light in focus: a beam thinner than 1/256 texel is widened to that, so that its share stays a ratio of numbers that
// float tells apart. It moves light by no more than that and loses none.
void widen(inout Cut cut) {
    vec2 along = cut.q - cut.p;
    float width = length(along);
    vec2 unit = width > 1e-12 ? along / width : vec2(1.0, 0.0);
    if (width < thinnest) cut.q = cut.p + thinnest * unit;
    vec2 aside = vec2(-unit.y, unit.x);
    float r = dot(aside, cut.r - cut.p), s = dot(aside, cut.s - cut.p);
    if (abs(r) < thinnest) cut.r += aside * ((r < 0.0 ? -thinnest : thinnest) - r);
    if (abs(s) < thinnest) cut.s += aside * ((s < 0.0 ? -thinnest : thinnest) - s);
}

void measure(inout Cut cut) {
    float diagonal = edgeArea(cut.p, cut.q);
    cut.upper = abs(edgeArea(cut.r, cut.p) + diagonal + edgeArea(cut.q, cut.r));
    cut.lower = abs(edgeArea(cut.p, cut.s) + edgeArea(cut.s, cut.q) - diagonal);
}

// Flux of both beams that falls into the texel, as BeamFlux.
float fluxInTexel(Quad quad, Cut cut) {
    measure(cut);
    float span = max(dot(cut.q - cut.p, cut.q - cut.p), thinnest * thinnest);
    float least = min(cut.upper, cut.lower);
    if (4.0 * least * least < thinnest * thinnest * span) {
        widen(cut);
        measure(cut);
    }
    float diagonal = edgeInSquare(cut.p, cut.q);
    float upper = abs(edgeInSquare(cut.r, cut.p) + diagonal + edgeInSquare(cut.q, cut.r));
    float lower = abs(edgeInSquare(cut.p, cut.s) + edgeInSquare(cut.s, cut.q) - diagonal);
    return quad.flux.x * min(upper / cut.upper, 1.0) + quad.flux.y * min(lower / cut.lower, 1.0);
}

vec2 meet(vec4 corner, vec4 plane, vec2 texel) {
    vec2 from = corner.xy - texel;
    float depth = (plane.x + dot(plane.yz, from - 0.5)) / (1.0 - dot(plane.yz, corner.zw));
    return from + depth * corner.zw;
}

#ifdef PATHS
float cross2(vec2 a, vec2 b) { return a.x * b.y - a.y * b.x; }

// Weights of the corners p, q, r, s at a place of the cut.
vec4 weightsAt(Cut cut, vec2 place) {
    vec2 along = cut.q - cut.p, to = place - cut.p;
    bool upper = cross2(along, to) * cross2(along, cut.r - cut.p) > 0.0;
    vec2 third = (upper ? cut.r : cut.s) - cut.p;
    float area = cross2(along, third);
    if (abs(area) < thinnest * thinnest) return vec4(0.25);
    float t = clamp(cross2(along, to) / area, 0.0, 1.0), q = clamp(cross2(to, third) / area, 0.0, 1.0 - t);
    return vec4(1.0 - t - q, q, upper ? t : 0.0, upper ? 0.0 : t);
}

// What is left of the light on its way to the texel, by channel.
vec3 arriving(Quad quad, Cut cut, vec4 plane, ivec2 texel) {
    // About the middle of the part of the beam that the texel holds.
    vec2 part = 0.25 * (clamp(cut.p, 0.0, 1.0) + clamp(cut.q, 0.0, 1.0) + clamp(cut.r, 0.0, 1.0) + clamp(cut.s, 0.0, 1.0));
    vec4 weights = weightsAt(cut, part);
    vec2 slope = weights.x * quad.p.zw + weights.y * quad.q.zw + weights.z * quad.r.zw + weights.w * quad.s.zw;
    float depth = plane.x + dot(plane.yz, part - 0.5), start = dot(weights, quad.starts);
    vec2 at = vec2(texel) + part;
    vec3 from = boxPoint(vec3((at - slope * (depth - start)) * boxExtent.w, start));
    if (testOcclusion != 0) {
        vec3 to = boxPoint(vec3(at * boxExtent.w, depth));
        if ((boxSize.w & 7) != 0) to += besideFace(octahedralDecode(texelFetch(normalMap, texel, 0).xy));
        float aside = distance(entryPoint(from).xz, entryPoint(to).xz);
        if (aside >= plane.w && (aside < -plane.w || isTaken(from, to, length(plane.yz) / boxExtent.w, receiverNumber))) return vec3(0.0);
    }
    float lit = testSurfaceShadow != 0 ? surfaceVisibility(from, 0.0) : 1.0;
    float metres = (depth - start) * length(vec3(slope * boxExtent.w, 1.0));
    return lit * extinction(extinctionPerMetre, metres - metresBefore);
}
#endif

void touch(Quad quad, Slab slab, ivec2 texel) {
    vec4 plane = texelFetch(tangentPlanes, texel, 0);
    if (plane.x < slab.from || plane.x >= slab.to) return;
    vec2 corner = vec2(texel);
    // Whether each corner's ray comes from the front: of -n·t the part that does not depend on how steep the face is.
    vec4 front = 1.0 - vec4(dot(plane.yz, quad.p.zw), dot(plane.yz, quad.q.zw), dot(plane.yz, quad.r.zw), dot(plane.yz, quad.s.zw));
    float cosine = 1.0;
    if (min(min(front.x, front.y), min(front.z, front.w)) < grazing) {
        // Light along the face: cut across the box's axis and weighed by the cosine instead.
        cosine = max(0.25 * dot(front, vec4(1.0)), 0.0);
        plane.yz = vec2(0.0);
    }
    Cut cut = Cut(meet(quad.p, plane, corner), meet(quad.q, plane, corner), meet(quad.r, plane, corner), meet(quad.s, plane, corner), 0.0, 0.0);
    float amount = fluxInTexel(quad, cut) * cosine * stepsPerFlux;
    if (!(amount > 0.0)) return;
    int index = texel.y * boxSize.x + texel.x;
#ifdef PATHS
    vec3 left = amount * arriving(quad, cut, plane, texel);
#else
    vec3 left = vec3(amount);
#endif
#ifdef COLOURED
    addFlux(3 * index, left.r);
    addFlux(3 * index + 1, left.g);
    addFlux(3 * index + 2, left.b);
#else
    if (left.r > 0.0) addFlux(index, left.r);
#endif
}

// A quad that touches more texels than this is left to many invocations: one alone would hold up all others.
const int most = 256;
const int tileSide = 16;
const int settled = -1;
// Its tiles: quad, slab (or `settled`), place of the tile's first texel.
layout(std430, binding = 9) buffer LargeBeams {
    int tileCount; // asked for; those beyond the buffer's end are not in it
    int padding[3];
    ivec4 tiles[];
};

// False where the buffer is full.
bool leaveToMany(int quad, int number, Slab slab) {
    ivec2 count = (slab.high - slab.low) / tileSide + 1;
    int first = atomicAdd(tileCount, count.x * count.y), end = first + count.x * count.y;
    bool fits = end <= tiles.length();
    for (int i = first; i < min(end, tiles.length()); ++i) {
        ivec2 tile = slab.low + tileSide * ivec2((i - first) % count.x, (i - first) / count.x);
        tiles[i] = ivec4(fits ? quad : -1, number, tile);
    }
    return fits;
}

void walk(Quad quad, Slab slab, int index, int number) {
    int count = (slab.high.x - slab.low.x + 1) * (slab.high.y - slab.low.y + 1);
    if (count > most && leaveToMany(index, number, slab)) return;
    ivec2 texel = slab.low;
    for (int i = 0; i < count; ++i) {
        touch(quad, slab, texel);
        if (++texel.x > slab.high.x) texel = ivec2(slab.low.x, texel.y + 1);
    }
}

#ifdef LARGE
// One work group a tile.
void main() {
    int count = min(tileCount, tiles.length());
    for (int item = int(gl_WorkGroupID.x); item < count; item += int(gl_NumWorkGroups.x)) {
        ivec4 tile = tiles[item];
        Quad quad;
        if (tile.x < 0 || !loadQuad(tile.x, quad)) continue;
        vec4 a = quad.p, b = quad.q, c = quad.r, d = quad.s;
        Slab slab;
        if (tile.y == settled) {
            lean(a), lean(b), lean(c), lean(d);
            settle(quad, a, b, c, d, slab);
        } else {
            slabAlong(quad, tile.y, 1, slabsAlong(quad), slab);
        }
        for (int i = int(gl_LocalInvocationIndex); i < tileSide * tileSide; i += int(gl_WorkGroupSize.x)) {
            ivec2 texel = tile.zw + ivec2(i % tileSide, i / tileSide);
            if (all(lessThanEqual(texel, slab.high))) touch(quad, slab, texel);
        }
    }
}
#else
void main() {
    int index = int(gl_GlobalInvocationID.y * gl_NumWorkGroups.x * gl_WorkGroupSize.x + gl_GlobalInvocationID.x);
    if (index >= quads.x * quads.y) return;
    Quad quad;
    if (!loadQuad(index, quad)) return;
    if (!(mayMeet(quad.p) || mayMeet(quad.q) || mayMeet(quad.r) || mayMeet(quad.s))) return;
    vec4 a = quad.p, b = quad.q, c = quad.r, d = quad.s;
    Slab slab;
    if (lean(a) && lean(b) && lean(c) && lean(d)) {
        if (settle(quad, a, b, c, d, slab)) walk(quad, slab, index, settled);
        return;
    }
    int slabs = slabsAlong(quad), run = slabs;
    for (int i = 0; i < slabs;) {
        bool met = slabAlong(quad, i, run, slabs, slab);
        if (met && run > 1) {
            run /= 2;
            continue;
        }
        if (met) walk(quad, slab, index, i);
        i += run;
        run = i & -i;
    }
}
#endif
