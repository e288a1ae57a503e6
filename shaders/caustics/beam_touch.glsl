// What one texel takes of a quad's beams: cut at the texel's own tangent plane (physics.md, point 5: exact on flat faces,
// and free of 1/area at a focus), less what the light loses on its way. EXTINCTION: water takes light. SHADED: something
// may shade the quad (beam_shade.glsl).
#include "interface/bindings.glsl"
#include "caustics/beam_cut.glsl"
#include "caustics/beam_sheet.glsl"
#include "caustics/beam_deposit.glsl"
#include "optics/optics.glsl"
layout(location = stepsPerFluxLocation) uniform float stepsPerFlux; // of the sums
#ifdef EXTINCTION
layout(location = extinctionPerMetreLocation) uniform vec3 extinctionPerMetre;
#endif
#ifdef SHADED
#include "caustics/beam_shade.glsl"
layout(location = testOcclusionLocation) uniform int testOcclusion;         // 0: nothing can be before the receiver
layout(location = testSurfaceShadowLocation) uniform int testSurfaceShadow; // 0: nothing stands out of the water
layout(location = receiverNumberLocation) uniform int receiverNumber;
layout(std430, binding = beamLitBuffer) readonly buffer BeamLit { float lit[]; }; // a beam: what things above the water leave of its light

bool isCut(int quad) { return testSurfaceShadow != 0 && (lit[2 * quad] < 1.0 || lit[2 * quad + 1] < 1.0); }

// The share of the light that arrives at the texel, whose middle comes from `from` at the surface.
vec3 arriving(Quad quad, int index, Sheet sheet, vec2 low, vec2 high, vec4 plane, ivec2 texel, vec3 from) {
    if (testOcclusion == 0) return vec3(isCut(index) ? surfaceVisibility(from, 0.0) : 1.0);
    // Where the cut is across the box's axis, rays still end on the surface itself.
    vec4 tangent = texelFetch(tangentPlanes, texel, 0);
    vec2 leaning = tangent.yz, rise = leaning / boxExtent.w;
    if (plane.yz == vec2(0.0)) plane.yz = leaning * min(1.0, steepestSlope / max(length(rise), 1e-6));
    BeamPart part = BeamPart(sheet, low, high, plane, texel, placesShown(tangent), isCut(index), rayStarts(quad));
    return passingShare(part, index, targetOf(receiverNumber, rise, vec3(0.0)));
}
#endif

#if defined(EXTINCTION) || defined(SHADED)
// What is left of the light on its way to the texel, by channel.
vec3 leftOf(Quad quad, int index, Sheet sheet, vec2 low, vec2 high, vec4 plane, ivec2 texel) {
    vec2 middle = middleIn(sheet, low, high);
    vec4 weights = weightsAt(sheet, middle);
    vec2 part = sheet.origin + middle;
    vec2 slope = weights.x * quad.p.zw + weights.y * quad.q.zw + weights.z * quad.r.zw + weights.w * quad.s.zw;
    float depth = plane.x + dot(plane.yz, part - 0.5), start = dot(weights, quad.starts);
    vec3 left = vec3(1.0);
#ifdef SHADED
    vec2 at = vec2(texel) + part;
    vec3 from = boxPoint(vec3((at - slope * (depth - start)) * boxExtent.w, start));
    left *= arriving(quad, index, sheet, low, high, plane, texel, from);
#endif
#ifdef EXTINCTION
    left *= extinction(extinctionPerMetre, (depth - start) * length(vec3(slope * boxExtent.w, 1.0)));
#endif
    return left;
}
#endif

void touch(Quad quad, int index, ivec2 texel) {
    Cut cut = cutAt(quad, texel);
    if (!mayTouch(cut)) return;
    Sheet sheet = sheetOf(cut.p, cut.q, cut.r, cut.s, quad.flux * (cut.cosine * stepsPerFlux));
    vec2 low, high;
    texelIn(sheet, vec2(0.0), low, high);
    float amount = fluxIn(sheet, low, high);
    if (!(amount > 0.0)) return;
#if defined(EXTINCTION) || defined(SHADED)
    deposit(texel, amount * leftOf(quad, index, sheet, low, high, cut.plane, texel));
#else
    deposit(texel, vec3(amount));
#endif
}
