// How much of a quad's light on a texel passes what stands in its way: rays spread evenly over the part of the beams that
// the texel holds, each followed exactly, and only where some triangle may be in the way at all. At an edge of shade that is
// coverage by area, at the texel's own resolution. VEILS: some triangles let part of the light through.
#include "caustics/beam_quads.glsl"
#include "caustics/beam_sheet.glsl"
#include "occlusion/occluders.glsl"
#include "caustics/rim.glsl"
#include "water/surface_shadow.glsl"

// The part of the beams in a texel.
struct BeamPart {
    Sheet sheet;
    vec2 low, high;  // its bounds, from the sheet's origin
    vec4 plane;      // of the texel: depth at its middle, m, and how it grows
    ivec2 texel;
    int shown;       // places of the texel (rim.glsl)
    bool cut;        // things above the water take some of the quad's light
    mat4x3 starts;   // of the rays through p, q, r, s at the water's surface
};

vec3 rayStart(vec4 ray, float start) { return boxPoint(vec3((ray.xy + start * ray.zw) * boxExtent.w, start)); }

mat4x3 rayStarts(Quad quad) {
    return mat4x3(rayStart(quad.p, quad.starts.x), rayStart(quad.q, quad.starts.y), rayStart(quad.r, quad.starts.z),
                  rayStart(quad.s, quad.starts.w));
}

vec3 surfaceAt(BeamPart part, vec2 place) {
    vec2 within = part.sheet.origin + place;
    return boxPoint(vec3((vec2(part.texel) + within) * boxExtent.w, part.plane.x + dot(part.plane.yz, within - 0.5)));
}

// Rays: a (0, 2)-sequence over the part's bounds, and one through its middle for a part so thin that they all miss it.
const int spreadRays = 16, middleRay = spreadRays;

// Moves the places by quad and texel, so that along an edge of shade what is too much and too little cancels.
vec2 shiftOf(int quad, ivec2 texel) {
    uvec2 v = uvec2(quad, texel.y * boxSize.x + texel.x) * 1664525u + 1013904223u;
    v.x += v.y * 1664525u, v.y += v.x * 1664525u;
    v ^= v >> 16u;
    v.x += v.y * 1664525u, v.y += v.x * 1664525u;
    v ^= v >> 16u;
    return vec2(v & 0xffffffu) / 16777216.0;
}

vec2 spreadPlace(BeamPart part, vec2 shift, int ray) {
    vec2 unit = vec2(float(ray) / float(spreadRays), float(bitfieldReverse(uint(ray))) / 4294967296.0);
    return mix(part.low, part.high, fract(unit + shift));
}

// Weights of the second and third corner of a triangle with its first at the origin; false outside of it.
bool weigh(vec2 second, vec2 third, vec2 place, out vec2 weights) {
    weights = vec2(cross2(place, third), cross2(second, place)) / cross2(second, third);
    return weights.x >= 0.0 && weights.y >= 0.0 && weights.x + weights.y <= 1.0;
}

// Which of the two beams a place is asked about. Folded ones lie over each other and share the rays.
bool isUpper(Sheet sheet, vec2 place, int ray) {
    float r = cross2(sheet.q, sheet.r);
    if (r * cross2(sheet.q, sheet.s) > 0.0) return (ray & 1) == 0;
    return cross2(sheet.q, place) * r > 0.0;
}

// Where the ray starts that has these weights in one of the two beams.
vec3 startIn(BeamPart part, bool upper, vec2 weights) {
    vec3 third = upper ? part.starts[2] : part.starts[3];
    return part.starts[0] + weights.x * (part.starts[1] - part.starts[0]) + weights.y * (third - part.starts[0]);
}

// Where a ray starts and ends. `inside`: 1 within the upper beam, 2 within the lower one, 0 in neither.
int rayOf(BeamPart part, vec2 shift, int ray, out vec3 from, out vec3 to) {
    bool middle = ray == middleRay;
    vec2 place = middle ? middleIn(part.sheet, part.low, part.high) : spreadPlace(part, shift, ray);
    to = surfaceAt(part, place);
    if (middle) {
        from = part.starts * weightsAt(part.sheet, place);
        return 1;
    }
    bool upper = isUpper(part.sheet, place, ray);
    vec2 weights;
    bool inside = weigh(part.sheet.q, upper ? part.sheet.r : part.sheet.s, place, weights);
    from = startIn(part, upper, weights);
    return inside ? (upper ? 1 : 2) : 0;
}

// Of the rays: those in each beam, a bit a ray, and those that are not taken.
struct Rays {
    uint upper, lower, lit;
    vec2 shift;
};

// Whether a ray ends on what the texel shows.
bool isShown(BeamPart part, vec3 to) {
    return part.shown == allPlaces || showsPlace(part.shown, boxLocal(to).xy / boxExtent.w - vec2(part.texel));
}

// Whether a ray has light before anything under water stands in its way.
bool isLitAt(BeamPart part, vec3 from) { return !part.cut || isLit(from); }

bool goesDown(vec3 from, vec3 to) { return dot(facingLight.xyz, to - from) > 0.0; }

// Whether a ray comes to what the texel shows, from above.
bool endsHere(BeamPart part, vec3 from, vec3 to) { return isShown(part, to) && goesDown(from, to); }

// Of light along a face some rays may come from behind it: those are none of its light, and what takes them is no shade. Where
// a trough dips below a receiver, no ray comes up to it.
Rays raysOf(BeamPart part, vec2 shift, Target target) {
    vec3 outward = target.rise.x * boxU.xyz + target.rise.y * boxW.xyz - boxT.xyz;
    Rays rays = Rays(0u, 0u, 0u, shift);
    for (int i = 0; i < spreadRays; ++i) {
        vec3 from, to;
        int beam = rayOf(part, shift, i, from, to);
        bool ends = endsHere(part, from, to);
        if (ends && dot(outward, to - from) >= 0.0) continue;
        if (beam == 1) rays.upper |= 1u << i;
        if (beam == 2) rays.lower |= 1u << i;
        if (ends && isLitAt(part, from)) rays.lit |= 1u << i;
    }
    vec3 from, to;
    if ((rays.upper | rays.lower) == 0u) {
        rayOf(part, shift, middleRay, from, to);
        rays.upper = 1u << middleRay;
        rays.lit = endsHere(part, from, to) && isLitAt(part, from) ? rays.upper : 0u;
    }
    rays.lit &= rays.upper | rays.lower;
    return rays;
}

#ifdef VEILS
vec3 passing[spreadRays + 1]; // of each ray, what is left of its light
#endif

// Rays of each beam stand for its flux by its area; those that all fell into a dark one, for the other.
vec3 weighedShare(BeamPart part, Rays rays) {
    vec2 density = part.sheet.flux / part.sheet.areas;
    if (rays.upper == 1u << middleRay || density.x * float(rays.upper) + density.y * float(rays.lower) == 0.0) density = vec2(1.0);
    float whole = density.x * float(bitCount(rays.upper)) + density.y * float(bitCount(rays.lower));
#ifdef VEILS
    vec3 sum = vec3(0.0);
    for (int i = 0; i <= middleRay; ++i) {
        if ((rays.lit >> i & 1u) == 0u) continue;
        sum += ((rays.upper >> i & 1u) != 0u ? density.x : density.y) * passing[i];
    }
    return sum / whole;
#else
    float lit = density.x * float(bitCount(rays.upper & rays.lit)) + density.y * float(bitCount(rays.lower & rays.lit));
    return vec3(lit / whole);
#endif
}

// Follows rays, `first` to `last`, past the triangles that were found.
void followFound(BeamPart part, Target target, int first, int last, inout Rays rays) {
    for (int t = 0; t < foundCount; ++t) {
        Facet facet;
        OccluderTriangle triangle = occluderTriangles[foundTriangles[t]];
        if (!facetOf(triangle, target, facet)) continue;
        for (int i = first; i <= last; ++i) {
            if ((rays.lit >> i & 1u) == 0u) continue;
            vec3 from, to, at;
            rayOf(part, rays.shift, i, from, to);
            if (!takes(facet, from, to, at)) continue;
#ifdef VEILS
            passing[i] *= passingTriangle(triangle, facet, at);
            if (passing[i] != vec3(0.0)) continue;
#endif
            rays.lit &= ~(1u << i);
        }
    }
}

// Where the rays to the corners of the part start: of a quad much wider than a texel, a small piece. The quad's own corners
// where both of its beams have some of the part, or one so thin that its weights are nowhere near it.
mat4x3 startsOf(BeamPart part, vec2 corners[4]) {
    Sheet sheet = part.sheet;
    float r = cross2(sheet.q, sheet.r);
    if (r * cross2(sheet.q, sheet.s) >= 0.0) return part.starts;
    vec4 sides;
    for (int i = 0; i < 4; ++i) sides[i] = r * cross2(sheet.q, corners[i]);
    bool upper = leastOf(sides) >= 0.0;
    if (!upper && greatestOf(sides) > 0.0) return part.starts;
    mat4x3 starts;
    for (int i = 0; i < 4; ++i) {
        vec2 weights;
        weigh(sheet.q, upper ? sheet.r : sheet.s, corners[i], weights);
        if (!all(lessThanEqual(abs(weights), vec2(2.0)))) return part.starts;
        starts[i] = startIn(part, upper, weights);
    }
    return starts;
}

// The share of the part's light that arrives, [0, 1] by channel. First the triangles are found that any ray may meet; where
// these are many, each ray finds its own. One loop for both: what it calls is long, and programs hold a copy for each call.
vec3 passingShare(BeamPart part, int quad, Target target) {
    vec2 corners[4] = vec2[](part.low, vec2(part.high.x, part.low.y), part.high, vec2(part.low.x, part.high.y));
    mat4x3 starts = startsOf(part, corners);
    mat4x3 ends;
    for (int i = 0; i < 4; ++i) ends[i] = surfaceAt(part, corners[i]);
    Pencil pencil = pencilOf(starts, ends, vec3(0.0));
    bool below = leastOf(facingLight.xyz * ends) > greatestOf(facingLight.xyz * starts);
    Rays rays;
    int node = 0, ray = -1; // -1: all rays
    while (ray <= middleRay) {
        findTriangles(node, pencil, target, mostNodes);
        bool all = sawAll(node);
        if (ray < 0) {
            if (foundCount == 0 && all && below && !part.cut && part.shown == allPlaces) return vec3(1.0);
            rays = raysOf(part, shiftOf(quad, part.texel), target);
#ifdef VEILS
            for (int i = 0; i <= middleRay; ++i) passing[i] = vec3(1.0);
#endif
        }
        if (ray >= 0 || all) followFound(part, target, max(ray, 0), ray < 0 ? middleRay : ray, rays);
        if (ray < 0 && all) break;
        if (ray >= 0 && !all && (rays.lit >> ray & 1u) != 0u) continue;
        do ++ray; while (ray <= middleRay && (rays.lit >> ray & 1u) == 0u);
        if (ray > middleRay) break;
        vec3 from, to;
        rayOf(part, rays.shift, ray, from, to);
        pencil = pencilOf(mat4x3(from, from, from, from), mat4x3(to, to, to, to), vec3(0.0));
        node = 0;
    }
    return weighedShare(part, rays);
}
