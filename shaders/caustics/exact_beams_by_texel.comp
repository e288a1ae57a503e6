// Exact beams, the pass over the quads that exact_beams.comp left in a list: each texel that a beam touches is cut at its
// own tangent plane (physics.md, point 5: exact on flat faces, and free of 1/area at a focus).
// One invocation for the two beams of a quad. In: footprints, flux, tangent planes, depth pyramid, the list. Out: flux
// sums, one channel or three (COLOURED). EXTINCTION: water takes light. SHADED: something may shade the quads.
// LARGE: the tiles of the quads of both lists that touch many texels, which the passes over the lists left.
#include "include/beam_quads.glsl"
#include "include/beam_sheet.glsl"
#include "include/beam_deposit.glsl"
#include "include/beam_lists.glsl"
#include "include/optics.glsl"
layout(local_size_x = 64) in;
layout(binding = 0) uniform sampler2D tangentPlanes;  // RGBA32F (tangent_planes.comp)
layout(location = 1) uniform float stepsPerFlux;      // of the sums
#ifdef EXTINCTION
layout(location = 2) uniform vec3 extinctionPerMetre;
#endif
#ifdef SHADED
#include "include/occlusion.glsl"
#include "include/octahedral.glsl"
#include "include/surface_shadow.glsl"
layout(binding = 7) uniform sampler2D normalMap;      // RG16
layout(location = 3) uniform int testOcclusion;       // 0: nothing can be before the receiver
layout(location = 4) uniform int testSurfaceShadow;   // 0: nothing stands out of the water
layout(location = 5) uniform int receiverNumber;
#endif
layout(location = 6) uniform int list;

vec2 meet(vec4 corner, vec4 plane, vec2 texel) {
    vec2 from = corner.xy - texel;
    float depth = (plane.x + dot(plane.yz, from - 0.5)) / (1.0 - dot(plane.yz, corner.zw));
    return from + depth * corner.zw;
}

#ifdef SHADED
// The share of the light that arrives at a place of the texel, from `from` at the surface.
float arriving(vec3 from, vec2 at, float depth, vec4 plane, ivec2 texel) {
    if (testOcclusion != 0) {
        vec3 to = boxPoint(vec3(at * boxExtent.w, depth));
        if ((boxSize.w & 7) != 0) to += besideFace(octahedralDecode(texelFetch(normalMap, texel, 0).xy));
        float aside = distance(entryPoint(from).xz, entryPoint(to).xz);
        if (aside >= plane.w && (aside < -plane.w || isTaken(from, to, length(plane.yz) / boxExtent.w, receiverNumber))) return 0.0;
    }
    return testSurfaceShadow != 0 ? surfaceVisibility(from, 0.0) : 1.0;
}
#endif

#if defined(EXTINCTION) || defined(SHADED)
// What is left of the light on its way to the texel, by channel.
vec3 leftOf(Quad quad, Sheet sheet, vec2 low, vec2 high, vec4 plane, ivec2 texel) {
    vec2 middle = middleIn(sheet, low, high);
    vec4 weights = weightsAt(sheet, middle);
    vec2 part = sheet.origin + middle;
    vec2 slope = weights.x * quad.p.zw + weights.y * quad.q.zw + weights.z * quad.r.zw + weights.w * quad.s.zw;
    float depth = plane.x + dot(plane.yz, part - 0.5), start = dot(weights, quad.starts);
    vec3 left = vec3(1.0);
#ifdef SHADED
    vec2 at = vec2(texel) + part;
    vec3 from = boxPoint(vec3((at - slope * (depth - start)) * boxExtent.w, start));
    left *= arriving(from, at, depth, plane, texel);
#endif
#ifdef EXTINCTION
    left *= extinction(extinctionPerMetre, (depth - start) * length(vec3(slope * boxExtent.w, 1.0)));
#endif
    return left;
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
    Sheet sheet = sheetOf(meet(quad.p, plane, corner), meet(quad.q, plane, corner), meet(quad.r, plane, corner),
                          meet(quad.s, plane, corner), quad.flux * (cosine * stepsPerFlux));
    vec2 low, high;
    texelIn(sheet, vec2(0.0), low, high);
    float amount = fluxIn(sheet, low, high);
    if (!(amount > 0.0)) return;
#if defined(EXTINCTION) || defined(SHADED)
    deposit(texel, amount * leftOf(quad, sheet, low, high, plane, texel));
#else
    deposit(texel, vec3(amount));
#endif
}

// A quad that touches more texels than this is left to many invocations: one alone would hold up all others.
const int most = 256;
const int tileSide = 16;
const int settled = -1;
// Its tiles: quad, slab (or `settled`), place of the tile's first texel.
layout(std430, binding = 9) buffer LargeBeams {
    uvec3 tileGroups; // to dispatch: a work group a tile
    int tileCount;    // asked for; those beyond the buffer's end are not in it
    ivec4 tiles[];
};

// False where the buffer is full.
bool leaveToMany(int quad, int number, Slab slab) {
    ivec2 count = (slab.high - slab.low) / tileSide + 1;
    int first = atomicAdd(tileCount, count.x * count.y), end = first + count.x * count.y;
    bool fits = end <= tiles.length();
    atomicMax(tileGroups.x, uint(min(end, tiles.length())));
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
    ivec4 tile = tiles[gl_WorkGroupID.x];
    Quad quad;
    if (tile.x < 0 || !loadQuad(tile.x, quad)) return;
    vec4 a = quad.p, b = quad.q, c = quad.r, d = quad.s;
    Slab slab;
    vec2 depths;
    if (tile.y == settled) {
        lean(a), lean(b), lean(c), lean(d);
        settle(a, b, c, d, slab, depths);
    } else {
        slabAlong(quad, tile.y, 1, slabsAlong(quad), slab);
    }
    for (int i = int(gl_LocalInvocationIndex); i < tileSide * tileSide; i += int(gl_WorkGroupSize.x)) {
        ivec2 texel = tile.zw + ivec2(i % tileSide, i / tileSide);
        if (all(lessThanEqual(texel, slab.high))) touch(quad, slab, texel);
    }
}
#else
void fill(int index) {
    Quad quad;
    if (!loadQuad(index, quad)) return;
    vec4 a = quad.p, b = quad.q, c = quad.r, d = quad.s;
    Slab slab;
    vec2 depths;
    if (lean(a) && lean(b) && lean(c) && lean(d)) {
        if (settle(a, b, c, d, slab, depths)) walk(quad, slab, index, settled);
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

void main() {
    int count = int(work[list].w), step = int(gl_NumWorkGroups.x * gl_WorkGroupSize.x);
    for (int i = int(gl_GlobalInvocationID.x); i < count; i += step) fill(listed[list * quads.x * quads.y + i]);
}
#endif
