// A photon's splat, and which of its texels are shaded: the photon stands for parallel rays to all of them. Along parallel
// rays a triangle's shade on the plane of the splat is a triangle, so its edges are asked in the map, texel by texel.
#include "interface/photons_left.glsl"
#include "occlusion/occluders.glsl"
#include "caustics/photon_place.glsl"

float overlap(float low, float high, int texel) { return clamp(min(high, float(texel + 1)) - max(low, float(texel)), 0.0, 1.0); }

// The square that a photon's flux is shared out in, texels.
struct Splat {
    vec2 low, high;
    ivec2 first, last;
    TexelPlane plane; // of the surface that it landed on
    ivec2 landed;
    float reach;
    float parts; // of the square, how many texels show that surface
    float apart; // m of depth that these are off the plane, at most
    bool asOne;  // all of the square has the fate of its middle: a face so steep that its texels lie far apart, or very many
};

// The part of the square that is the texel's; 0 where it shows another surface.
float partOf(Splat square, ivec2 texel) {
    if (!sameSurface(texel, square.plane, square.landed, square.reach)) return 0.0;
    return overlap(square.low.x, square.high.x, texel.x) * overlap(square.low.y, square.high.y, texel.y);
}

// On the plane that the photon landed on, at a place in texels.
float planeDepth(Splat square, vec2 at) { return square.plane.depth + dot(square.plane.rise, (at - vec2(square.landed) - 0.5) * boxExtent.w); }
vec3 placeOf(Splat square, vec2 at) { return boxPoint(vec3(at * boxExtent.w, planeDepth(square, at))); }

// The surface in a texel's middle lies so much below that plane, m.
float belowPlane(Splat square, ivec2 texel) { return texelFetch(tangentPlanes, texel, 0).x - planeDepth(square, vec2(texel) + 0.5); }

vec2 middleOf(Splat square) { return 0.5 * (square.low + square.high); }

const float steepestShaded = 3.0; // rise
const float widestShaded = 64.0;  // texels

Splat splatAt(vec2 middle, float size, ivec2 landed) {
    vec2 low = middle - 0.5 * size, high = middle + 0.5 * size;
    TexelPlane plane = planeAt(landed);
    return Splat(low, high, ivec2(floor(low)), ivec2(floor(high)), plane, landed, 0.5 * size, 0.0, 0.0, length(plane.rise) > steepestShaded || size > widestShaded);
}

// Counts a texel of the square.
void countTexel(inout Splat square, ivec2 texel) {
    float part = partOf(square, texel);
    square.parts += part;
    if (part > 0.0) square.apart = max(square.apart, abs(belowPlane(square, texel)));
}

// Rays to the texels that the square touches, parallel to the photon's own.
Pencil raysTo(Splat square, vec3 back) {
    vec2 low = square.asOne ? middleOf(square) : vec2(square.first), high = square.asOne ? low : vec2(square.last + 1);
    mat4x3 to = mat4x3(placeOf(square, low), placeOf(square, vec2(high.x, low.y)), placeOf(square, high), placeOf(square, vec2(low.x, high.y)));
    return pencilOf(mat4x3(to[0] + back, to[1] + back, to[2] + back, to[3] + back), to, square.asOne ? vec3(0.0) : square.apart * boxT.xyz);
}

// A triangle in the way of parallel rays, each to a place on the splat's plane: numbers at the square's first texel, how they
// grow right and down, and how by metres that the ray ends below the plane.
struct Shadow {
    vec3 inside, insideRight, insideDown, insideBelow; // m · m within each edge; at least `least` where the triangle is met
    vec3 least;
    vec4 behind; // m that the ray's end is past the triangle
    vec2 taken;  // rays are taken whose ends are so far past it, m
};

vec3 insideAt(Facet facet, vec3 from, vec3 to, float behind, float before) {
    vec3 at = from + (before / (before + behind)) * (to - from);
    return vec3(dot(cross(facet.normal, facet.b - facet.a), at - facet.a), dot(cross(facet.normal, facet.c - facet.b), at - facet.b),
                dot(cross(facet.normal, facet.a - facet.c), at - facet.c));
}

// False where the rays run along the triangle.
bool shadowOf(Facet facet, Splat square, vec3 back, out Shadow shadow) {
    float way = dot(facet.normal, back);
    if (abs(way) < 1e-12 * length(back)) return false;
    vec3 normal = way < 0.0 ? -facet.normal : facet.normal;
    vec2 first = vec2(square.first) + 0.5;
    vec3 end = placeOf(square, first);
    vec3 ends[4] = vec3[](end, placeOf(square, first + vec2(1.0, 0.0)), placeOf(square, first + vec2(0.0, 1.0)), end + boxExtent.w * boxT.xyz);
    vec3 inside[4];
    for (int i = 0; i < 4; ++i) {
        shadow.behind[i] = dot(normal, facet.a - ends[i]);
        inside[i] = insideAt(facet, ends[i] + back, ends[i], shadow.behind[i], abs(way) - shadow.behind[i]);
    }
    shadow.behind.yzw -= shadow.behind.x;
    shadow.inside = inside[0], shadow.insideRight = inside[1] - inside[0], shadow.insideDown = inside[2] - inside[0];
    shadow.insideBelow = (inside[3] - inside[0]) / boxExtent.w, shadow.behind.w /= boxExtent.w;
    float slack = roundingOf(end) + roundingOf(end + back);
    shadow.least = -slack * vec3(length(facet.b - facet.a), length(facet.c - facet.b), length(facet.a - facet.c));
    shadow.taken = vec2(facet.contact, abs(way) + slack);
    return true;
}

bool isIn(Shadow shadow, vec2 at, float below) {
    float behind = shadow.behind.x + dot(shadow.behind.yzw, vec3(at, below));
    vec3 inside = shadow.inside + at.x * shadow.insideRight + at.y * shadow.insideDown + below * shadow.insideBelow;
    return behind > shadow.taken.x && behind <= shadow.taken.y && all(greaterThanEqual(inside, shadow.least));
}

// What is found once for all texels: the shadows of a few triangles, or nothing where there are too many.
Shadow shadows[mostShadows];
int shadowCount; // < 0: each texel's ray is followed alone

// `found`: triangles that may be in the way, < 0 for more than these.
void findShadows(Splat square, vec3 back, Target target, int found, int triangles[mostShadows]) {
    shadowCount = 0;
#ifdef VEILS
    if (found > 0) found = -1;
#endif
    for (int i = 0; i < found; ++i) {
        Facet facet;
        Shadow shadow;
        if (facetOf(occluderTriangles[triangles[i]], target, facet) && shadowOf(facet, square, back, shadow)) shadows[shadowCount++] = shadow;
    }
    if (found < 0) shadowCount = -1;
}

// The share that arrives at a place of the map, so much below the splat's plane.
vec3 arrivingAt(Splat square, vec2 at, float below, vec3 back, Target target) {
    if (shadowCount < 0) {
        vec3 to = placeOf(square, at) + below * boxT.xyz;
        return passingRay(to + back, to, target);
    }
    bool taken = false;
    for (int i = 0; i < shadowCount; ++i) taken = taken || isIn(shadows[i], at - vec2(square.first) - 0.5, below);
    return vec3(taken ? 0.0 : 1.0);
}
