// The level map in one pass (thesis 4.4 and 4.5 with nothing drawn): each beam finds the planes that it can meet, walks
// the texels there, and gives its irradiance to those whose centre it covers on the texel's own plane.
// One invocation for the two beams of a quad of the water's grid, a work group for a tile of quads. In: beams, planes of the
// texels (levelmap/PlaneDepths.h), normal map; with PATHS, for what happens to light on its way, position map and
// surface shadow. Out: flux sums, one channel or three (COLOURED), of irradiance times the area of a texel, as if the
// whole mean light reached it. BROAD: work groups for the quads that touch many texels, which the pass over all quads left.
#include "interface/bindings.glsl"
#include "caustics/quad_walk.glsl"
#include "caustics/footprint.glsl"
#include "caustics/beam_deposit.glsl"
#include "caustics/texel_coverage.glsl"
#include "optics/octahedral.glsl"
#include "optics/optics.glsl"
#include "caustics/listed_quads.glsl"
#ifndef BROAD
#include "caustics/tile_quads.glsl"
#endif
#ifdef PATHS
#include "water/surface_shadow.glsl"
layout(binding = positionMapUnit) uniform sampler2D positionMap; // RG32F
#endif
layout(binding = normalMapUnit) uniform sampler2D normalMap; // RG16
layout(std430, binding = beamOriginsBuffer) readonly buffer BeamOrigins { vec4 origins[]; };
layout(std430, binding = beamDirectionsBuffer) readonly buffer BeamDirections { vec4 directions[]; };
layout(location = stepsPerFluxLocation) uniform float stepsPerFlux; // of the sums
layout(location = depthLimitsLocation) uniform vec2 depthLimits;    // planes outside of these are left out, m
layout(location = extinctionPerMetreLocation) uniform vec3 extinctionPerMetre;
layout(location = testSurfaceShadowLocation) uniform int testSurfaceShadow; // 0: nothing stands out of the water

vec4 cornerFootprint(int vertex, out float start) {
    vec3 origin = boxLocal(origins[vertex].xyz);
    start = origin.z;
    return rayFootprint(origin, boxDirection(directions[vertex].xyz));
}

// A beam without light takes no part in where the quad is looked for.
bool takesPart(inout Quad quad) {
    if (!meetsPlanes(quad.r, quad.p, quad.q)) quad.flux.x = 0.0;
    if (!meetsPlanes(quad.q, quad.p, quad.s)) quad.flux.y = 0.0;
    if (!(quad.flux.x > 0.0)) quad.r = quad.p;
    if (!(quad.flux.y > 0.0)) quad.s = quad.p;
    return quad.flux.x > 0.0 || quad.flux.y > 0.0;
}

// Those whose centres may be covered; corners snap by less than the margin.
const float margin = 1.0 / 64.0; // texels
vec2 firstTexel(vec2 least) { return ceil(least - 0.5 - margin); }
vec2 lastTexel(vec2 most) { return floor(most - 0.5 + margin); }

float depthOf(ivec2 texel) { return texelFetch(depthPyramid, texel, 0).x; } // of its plane

bool settle(Quad quad, out Slab slab, out vec2 depths) {
    depths = depthLimits;
    return settle(quad.p, quad.q, quad.r, quad.s, 0.0, slab, depths);
}

Place placeOf(Quad quad) {
    Place place = nowhere();
    if (!settle(quad, place.slab, place.depths)) return place;
    place.settled = texelsOf(place.slab) <= mostTexels || place.depths.x == place.depths.y;
    place.slabs = place.settled ? 1 : slabsAlong(quad, place.depths.y - place.depths.x);
    return place;
}

// Over the depths that the quad has settled on.
bool slabAlong(Quad quad, vec2 depths, int number, int count, out Slab slab) {
    vec2 part = slabDepths(depths, number, count);
    if (!spanBetween(quad.p, quad.q, quad.r, quad.s, part, slab)) return false;
    vec2 found = depthRange(depthPyramid, slab.low, slab.high);
    slab.from = part.x;
    slab.to = number + 1 == count ? everywhere : part.y;
    return found.x <= part.y && found.y >= part.x;
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

void visit(Quad quad, int index, Slab slab, ivec2 texel, float depth) {
    if (depth < depthLimits.x || depth > depthLimits.y) return;
    vec2 centre = vec2(texel) + 0.5;
    Corners corners = Corners(snapped(onPlane(quad.p, depth) - centre), snapped(onPlane(quad.q, depth) - centre),
                              snapped(onPlane(quad.r, depth) - centre), snapped(onPlane(quad.s, depth) - centre));
    bvec2 covers = covering(corners, slab.far);
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

void doQuad(Quad quad, int index, int part, int parts) { walk(quad, index, part, parts); }

#ifdef BROAD
void main() { doListed(plain); }
#else
void main() {
    ivec2 at;
    Quad quad;
    if (!workQuad(quads, at)) return;
    int index = at.y * quads.x + at.x;
    if (!loadQuad(index, quad)) return;
    Place place = placeOf(quad);
    if (place.slabs == 0) return;
    if (place.settled && texelsOf(place.slab) <= mostTexels) walkNarrow(quad, index, place.slab);
    else leaveTo(plain + broad, index);
}
#endif
