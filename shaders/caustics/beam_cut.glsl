// A quad's corner rays on the tangent plane of a texel.
#include "interface/bindings.glsl"
#include "caustics/beam_quads.glsl"
layout(binding = tangentPlanesUnit) uniform sampler2D tangentPlanes; // RGBA32F (tangent_planes.comp)

struct Cut {
    vec2 p, q, r, s; // texels from the texel's corner
    vec4 plane;      // as in the map; level where light runs along the face
    float cosine;    // that the light is weighed by then, else 1
};

vec2 meet(vec4 corner, vec4 plane, vec2 texel) {
    vec2 from = corner.xy - texel;
    float depth = (plane.x + dot(plane.yz, from - 0.5)) / (1.0 - dot(plane.yz, corner.zw));
    return from + depth * corner.zw;
}

Cut cutAt(Quad quad, ivec2 texel) {
    Cut cut;
    vec4 plane = texelFetch(tangentPlanes, texel, 0);
    vec2 corner = vec2(texel);
    // Whether each corner's ray comes from the front: of -n·t the part that does not depend on how steep the face is.
    vec4 front = 1.0 - vec4(dot(plane.yz, quad.p.zw), dot(plane.yz, quad.q.zw), dot(plane.yz, quad.r.zw), dot(plane.yz, quad.s.zw));
    cut.cosine = 1.0;
    if (min(min(front.x, front.y), min(front.z, front.w)) < grazing) {
        // Light along the face: cut across the box's axis and weighed by the cosine instead.
        cut.cosine = max(0.25 * dot(front, vec4(1.0)), 0.0);
        plane.yz = vec2(0.0);
    }
    cut.p = meet(quad.p, plane, corner), cut.q = meet(quad.q, plane, corner);
    cut.r = meet(quad.r, plane, corner), cut.s = meet(quad.s, plane, corner);
    cut.plane = plane;
    return cut;
}

// Whether the beams come to the texel at all: false only where they surely do not.
bool mayTouch(Cut cut) {
    vec2 least = min(min(cut.p, cut.q), min(cut.r, cut.s)), most = max(max(cut.p, cut.q), max(cut.r, cut.s));
    return cut.cosine > 0.0 && all(lessThanEqual(least - thinnest, vec2(1.0))) && all(greaterThanEqual(most + thinnest, vec2(0.0)));
}
