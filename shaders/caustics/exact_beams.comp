// Exact beams, the pass over all quads. Each finds which texels it may touch. Where they lie in one plane and nothing can
// shade it, as on most of a floor, it is cut with that plane once and each texel takes its share here; other quads are
// left to exact_beams_by_texel.comp, in lists, so that none of them holds up the many that are simple.
// One invocation for the two beams of a quad, a work group for a tile of quads. In: footprints (footprints.comp), flux, depth
// pyramid. Out: flux sums, one channel or three (COLOURED), and the lists. EXTINCTION: water takes light. SHADED: something
// may shade something.
#include "interface/bindings.glsl"
#include "caustics/beam_quads.glsl"
#include "caustics/beam_sheet.glsl"
#include "caustics/beam_deposit.glsl"
#include "caustics/beam_lists.glsl"
#include "optics/optics.glsl"
#include "caustics/tile_quads.glsl"
layout(local_size_x = 64) in;
layout(location = stepsPerFluxLocation) uniform float stepsPerFlux; // of the sums
#ifdef EXTINCTION
layout(location = extinctionPerMetreLocation) uniform vec3 extinctionPerMetre;
#endif
#ifdef SHADED
#include "occlusion/occluders.glsl"
layout(location = testOcclusionLocation) uniform int testOcclusion;         // 0: nothing can be before the receiver
layout(location = testSurfaceShadowLocation) uniform int testSurfaceShadow; // 0: nothing stands out of the water
layout(location = receiverNumberLocation) uniform int receiverNumber;
layout(std430, binding = beamLitBuffer) readonly buffer BeamLit { float lit[]; };
#endif

// Depths within this much, in texels, are one plane.
const float flatness = 2e-3;

// The depth, in the box, of a place on the plane that leans, this much below it.
float depthOf(vec2 place, float upright) { return upright + dot(boxShear.xy * boxExtent.w, place); }

#ifdef SHADED
vec3 rayStart(vec4 ray, float start) { return boxPoint(vec3((ray.xy + start * ray.zw) * boxExtent.w, start)); }
vec3 rayEnd(vec4 leant, float upright) {
    vec2 place = leant.xy + upright * leant.zw;
    return boxPoint(vec3(place * boxExtent.w, depthOf(place, upright)));
}

// All of a quad's light, down to this depth.
Pencil pencilTo(Quad quad, Leant leant, float upright) {
    return pencilOf(mat4x3(rayStart(quad.p, quad.starts.x), rayStart(quad.q, quad.starts.y), rayStart(quad.r, quad.starts.z),
                           rayStart(quad.s, quad.starts.w)),
                    mat4x3(rayEnd(leant.p, upright), rayEnd(leant.q, upright), rayEnd(leant.r, upright), rayEnd(leant.s, upright)), vec3(0.0));
}

const float mostLean = 8.0; // depth along the map

const int arrives = 0, taken = 1, unsure = 2;

// What becomes of a quad's light on its way to the texels between two depths.
int fateOf(Quad quad, int index, Leant leant, Slab slab, vec2 depths) {
    if (testSurfaceShadow != 0) {
        vec2 share = vec2(lit[2 * index], lit[2 * index + 1]);
        if (share == vec2(0.0)) return taken;
        if (share != vec2(1.0)) return unsure;
    }
    if (testOcclusion == 0) return arrives;
    if (depthNode(depthPyramid, slab.low, slab.high).z < 0.0) return unsure; // a rim
    // A surface that only leans lies no further apart than this; else there is an edge, and what is on it may be in the way.
    ivec2 span = slab.high - slab.low + 1;
    float leans = mostLean * float(max(span.x, span.y)) * boxExtent.w;
    Target target = targetOf(receiverNumber, boxShear.xy, min(depths.y - depths.x, leans) * boxT.xyz);
    Pencil pencil = pencilTo(quad, leant, depths.y);
    // Where a trough dips below the receiver, light does not come up to it.
    float above = leastOf(facingLight.xyz * pencil.to) - (depths.y - depths.x);
    if (above <= greatestOf(facingLight.xyz * pencil.from)) return unsure;
    return mayBeTaken(pencil, target) ? unsure : arrives;
}
#endif

#ifdef EXTINCTION
// Metres of water from the surface to each corner of the sheet.
vec4 metresTo(Quad quad, Leant leant, float upright) {
    vec4 rays[4] = vec4[](quad.p, quad.q, quad.r, quad.s), leants[4] = vec4[](leant.p, leant.q, leant.r, leant.s);
    vec4 metres;
    for (int i = 0; i < 4; ++i) {
        float depth = depthOf(leants[i].xy + upright * leants[i].zw, upright);
        metres[i] = (depth - quad.starts[i]) * length(vec3(rays[i].zw * boxExtent.w, 1.0));
    }
    return metres;
}
#endif

void depositOnPlane(Quad quad, Leant leant, Slab slab, float upright) {
    Sheet sheet = sheetOf(leant.p.xy + upright * leant.p.zw, leant.q.xy + upright * leant.q.zw,
                          leant.r.xy + upright * leant.r.zw, leant.s.xy + upright * leant.s.zw, quad.flux * stepsPerFlux);
#ifdef EXTINCTION
    vec4 metres = metresTo(quad, leant, upright);
#endif
    ivec2 texel = slab.low;
    int count = texelsOf(slab);
    for (int i = 0; i < count; ++i) {
        vec2 low, high;
        texelIn(sheet, vec2(texel), low, high);
        vec3 amount = vec3(fluxIn(sheet, low, high));
#ifdef EXTINCTION
        amount *= extinction(extinctionPerMetre, dot(metres, weightsAt(sheet, middleIn(sheet, low, high))));
#endif
        deposit(texel, amount);
        if (++texel.x > slab.high.x) texel = ivec2(slab.low.x, texel.y + 1);
    }
}

void main() {
    ivec2 at;
    if (!workQuad(quads, at)) return;
    int index = at.y * quads.x + at.x;
    Quad quad;
    if (!loadQuad(index, quad)) return;
    if (!(mayMeet(quad.p) || mayMeet(quad.q) || mayMeet(quad.r) || mayMeet(quad.s))) return;
    Leant leant;
    Slab slab;
    vec2 depths;
    int list = plain;
    bool narrow = false, onPlane = false;
    if (lean(quad, leant)) {
        if (!settle(leant, slab, depths)) return;
        narrow = texelsOf(slab) <= mostTexels;
        onPlane = narrow && depths.y - depths.x <= flatness * boxExtent.w;
#ifdef SHADED
        int fate = fateOf(quad, index, leant, slab, depths);
        if (fate == taken) return;
        if (fate == unsure) list = shaded, onPlane = false, narrow = texelsOf(slab) <= mostGathered;
    } else {
        list = shaded;
#endif
    }
    if (onPlane) depositOnPlane(quad, leant, slab, 0.5 * (depths.x + depths.y));
    else leaveTo(narrow ? list : list + broad, index);
}
