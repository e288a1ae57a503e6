// The triangles of all receivers as things that stand in light's way, in a bounding volume hierarchy (src/occlusion,
// core/Bvh.h). Light is asked about as a pencil: the straight rays between a piece of the water's surface and a piece of a
// receiver. First come the triangles that may cut the pencil, then single rays against those. Whatever has no thickness,
// stands along the light or is finer than a texel is met all the same, at any size of a map.
// VEILS: some let part of the light through (veils.glsl). Positions in m from the scene's origin.
#include "interface/bindings.glsl"
#include "levelmap/facing.glsl"
#include "interface/occluders.glsl"
#ifdef VEILS
#include "occlusion/veils.glsl"
#endif

layout(std430, binding = occluderNodesBuffer) readonly buffer OccluderNodes { OccluderNode occluderNodes[]; };
layout(std430, binding = occluderTrianglesBuffer) readonly buffer OccluderTriangles { OccluderTriangle occluderTriangles[]; };

// Straight rays from anywhere within four places to anywhere within four others.
struct Pencil {
    mat4x3 from, to;
    vec3 low, high;             // bounds of `from`
    vec3 perLowWay, perHighWay; // 1 / how these move on the way to those of `to`: the lower ones downwards, the upper ones upwards
    vec3 aside;                 // all rays may be moved by up to this, forth or back
};

// 1 / x, huge instead of infinite.
vec3 reciprocal(vec3 x) { return 1.0 / mix(x, vec3(1e-30), lessThan(abs(x), vec3(1e-30))); }

Pencil pencilOf(mat4x3 from, mat4x3 to, vec3 aside) {
    Pencil pencil;
    pencil.from = from, pencil.to = to;
    vec3 low = min(min(from[0], from[1]), min(from[2], from[3])), high = max(max(from[0], from[1]), max(from[2], from[3]));
    vec3 toLow = min(min(to[0], to[1]), min(to[2], to[3])), toHigh = max(max(to[0], to[1]), max(to[2], to[3]));
    vec3 room = 4e-7 * (max(abs(low), abs(high)) + max(abs(toLow), abs(toHigh))) + abs(aside); // for rounding, too
    pencil.low = low - room, pencil.high = high + room;
    pencil.aside = aside;
    pencil.perLowWay = reciprocal(low - toLow), pencil.perHighWay = reciprocal(toHigh - high);
    return pencil;
}

// Whether the pencil's bounds meet a box anywhere on their way. Conservative.
bool meets(Pencil pencil, vec3 low, vec3 high) {
    // Where an upper bound rises past the box's lower face, and a lower one falls past its upper face.
    vec3 rises = (low - pencil.high) * pencil.perHighWay, falls = (pencil.low - high) * pencil.perLowWay;
    bvec3 rising = greaterThan(pencil.perHighWay, vec3(0.0)), falling = greaterThan(pencil.perLowWay, vec3(0.0));
    vec3 first = max(mix(vec3(0.0), rises, rising), mix(vec3(0.0), falls, falling));
    vec3 last = min(mix(rises, vec3(1.0), rising), mix(falls, vec3(1.0), falling));
    return max(max(first.x, first.y), max(first.z, 0.0)) <= min(min(last.x, last.y), min(last.z, 1.0));
}

// The surface that light goes to, as far as an occluder may be that surface itself.
struct Target {
    int receiver;
    vec2 rise;   // of its depth in the map, m/m
    vec3 near;   // so far before the rays' ends, m, it may lie itself
    vec4 plane;  // depth below a plane is dot(xyz, place) + w, m; what lies all within `same` of it is this surface
    float same;  // m; < 0: none
};

Target targetOf(int receiver, vec2 rise, vec3 near) { return Target(receiver, rise, near, vec4(0.0), -1.0); }

// A triangle, and how far behind its plane light may end and not be taken by it, m.
struct Facet {
    vec3 a, b, c;
    vec3 normal; // unit
    float contact;
    bool veiled;
};

const float steepestSlope = 15.0;
const float reachOfLean = 1.45; // texels from corner to corner: the edge to a neighbour may be at one, the ray's end at the other

// A texel's surface is flat, so the receiver's own triangles may lie before it by as much as they lean against it within the
// texel. Faces that another map holds, a wall beside a floor, are no part of it, nor is the underside of what hangs over
// it. Where two receivers lie in one plane, the later one is on top.
float contactOf(vec3 normal, OccluderTriangle triangle, Target target) {
    float tie = 1e-2 * boxExtent.w;
    if (triangle.receiver != target.receiver) return triangle.receiver < target.receiver ? tie : -tie;
    if (!belongsToMap(normal)) return tie;
    vec3 below = vec3(dot(target.plane.xyz, triangle.a), dot(target.plane.xyz, triangle.b), dot(target.plane.xyz, triangle.c)) + target.plane.w;
    if (all(lessThanEqual(abs(below), vec3(target.same)))) return 1e30;
    vec2 rise = target.rise * min(1.0, steepestSlope / max(length(target.rise), 1e-6));
    float stretch = sqrt(1.0 + dot(rise, rise)); // of a texel on the surface
    float cosine = abs(dot(normal, rise.x * boxU.xyz + rise.y * boxW.xyz - boxT.xyz)) / stretch;
    if (cosine < 0.5 && dot(normal, boxT.xyz) > 0.0) return tie;
    return tie + reachOfLean * boxExtent.w * stretch * sqrt(max(1.0 - cosine * cosine, 0.0)) + abs(dot(normal, target.near));
}

// False for a triangle without an area.
bool facetOf(OccluderTriangle triangle, Target target, out Facet facet) {
    vec3 area = cross(triangle.b - triangle.a, triangle.c - triangle.a);
    float size = length(area);
    if (!(size > 0.0)) return false;
    facet.a = triangle.a, facet.b = triangle.b, facet.c = triangle.c;
    facet.normal = area / size;
    facet.contact = contactOf(facet.normal, triangle, target);
    facet.veiled = triangle.veil >= 0;
    return true;
}

// How far single precision may put a place aside, m.
float roundingOf(vec3 place) { return 4e-7 * (abs(place.x) + abs(place.y) + abs(place.z)); }

float leastOf(vec4 v) { return min(min(v.x, v.y), min(v.z, v.w)); }
float greatestOf(vec4 v) { return max(max(v.x, v.y), max(v.z, v.w)); }

// Whether all crossings of the plane lie outside of the edge from `a` to `b`: between the parts of the way `parts`.
bool isOutside(vec3 normal, vec3 a, vec3 b, Pencil pencil, vec2 parts) {
    vec3 inward = cross(normal, b - a);
    float from = greatestOf(inward * pencil.from) - dot(inward, a), to = greatestOf(inward * pencil.to) - dot(inward, a);
    float slack = 1e-6 * (abs(dot(inward, a)) + length(inward) * 1e-3 * boxExtent.w) + abs(dot(inward, pencil.aside));
    return max(mix(from, to, parts.x), mix(from, to, parts.y)) < -slack;
}

// Whether some ray of the pencil may be taken; false only where none is.
bool mayTake(Facet facet, Pencil pencil) {
    float plane = dot(facet.normal, facet.a);
    vec4 from = facet.normal * pencil.from - plane, to = facet.normal * pencil.to - plane;
    if (dot(from, vec4(1.0)) < 0.0) from = -from, to = -to;
    float aside = abs(dot(facet.normal, pencil.aside));
    float nearest = leastOf(from) - aside, ends = leastOf(to) - aside;
    if (nearest > roundingOf(pencil.from[0]) && ends >= -facet.contact) return false;
    // Parts of the way at which rays may cross the plane.
    vec2 parts = vec2(0.0, 1.0);
    if (nearest > 0.0 && ends < 0.0) parts = vec2(nearest / (nearest - ends), (greatestOf(from) + aside) / (greatestOf(from) + aside - min(greatestOf(to) + aside, 0.0)));
    return !isOutside(facet.normal, facet.a, facet.b, pencil, parts) && !isOutside(facet.normal, facet.b, facet.c, pencil, parts) &&
           !isOutside(facet.normal, facet.c, facet.a, pencil, parts);
}

#ifdef VEILS
// Whether a ray is on the inner side of the edge from `a` to `b`; `turn`: sign of the way along the triangle's normal. The
// numbers are the same for both triangles of an edge, and a ray right on it belongs to one of them: met twice, a sheet would
// have dark seams.
bool ownsRay(vec3 from, vec3 way, vec3 a, vec3 b, float turn) {
    bool swapped = b.x < a.x || (b.x == a.x && (b.y < a.y || (b.y == a.y && b.z < a.z)));
    precise vec3 low = (swapped ? b : a) - from, high = (swapped ? a : b) - from;
    precise float side = dot(way, cross(low, high));
    side = swapped ? -side : side;
    return side * turn > 0.0 || (side == 0.0 && !swapped);
}
#endif

// Whether one ray is taken, and where. Edges reach as much further as rounding may be off, so that none slips through
// between two triangles. What starts in the plane is behind it: a lid on the water.
bool takes(Facet facet, vec3 from, vec3 to, out vec3 at) {
    float slack = roundingOf(from) + roundingOf(to);
    float before = dot(facet.normal, from - facet.a), behind = dot(facet.normal, to - facet.a);
    behind = abs(before) <= slack ? -abs(behind) : before < 0.0 ? -behind : behind;
    if (behind >= -facet.contact) return false;
    before = abs(before);
    at = from + (before / max(before - behind, 1e-30)) * (to - from);
#ifdef VEILS
    if (facet.veiled) {
        vec3 way = to - from;
        float turn = sign(dot(way, facet.normal));
        return ownsRay(from, way, facet.a, facet.b, turn) && ownsRay(from, way, facet.b, facet.c, turn) && ownsRay(from, way, facet.c, facet.a, turn);
    }
#endif
    vec3 ab = facet.b - facet.a, bc = facet.c - facet.b, ca = facet.a - facet.c;
    vec3 inside = vec3(dot(cross(facet.normal, ab), at - facet.a), dot(cross(facet.normal, bc), at - facet.b),
                       dot(cross(facet.normal, ca), at - facet.c));
    return all(greaterThanEqual(inside, -slack * vec3(length(ab), length(bc), length(ca))));
}

// Weights of the corners at a place of the triangle.
vec3 cornerWeights(Facet facet, vec3 at) {
    vec3 ab = facet.b - facet.a, ac = facet.c - facet.a, way = at - facet.a;
    float whole = dot(facet.normal, cross(ab, ac));
    vec2 weights = vec2(dot(facet.normal, cross(way, ac)), dot(facet.normal, cross(ab, way))) / whole;
    return vec3(1.0 - weights.x - weights.y, weights);
}

// The share of a ray's light that goes on behind the place where it meets a triangle, by channel.
vec3 passingTriangle(OccluderTriangle triangle, Facet facet, vec3 at) {
#ifdef VEILS
    if (triangle.veil >= 0) return passingVeil(triangle.veil, cornerWeights(facet, at));
#endif
    return vec3(0.0);
}

// Triangles that may take rays of a pencil, found a few at a time.
const int mostFound = 16;
int foundTriangles[mostFound];
int foundCount;

// Goes on at `node` until there is no room for another leaf's, all is seen or so many nodes are; then `node` is the next.
void findTriangles(inout int node, Pencil pencil, Target target, int most) {
    foundCount = 0;
    int end = occluderNodes.length();
    while (node < end && foundCount <= mostFound - 4 && most > 0) {
        // On to the next leaf first: triangles are then asked side by side (Aila and Laine 2009).
        int items = 0;
        while (node < end && items == 0 && most > 0) {
            OccluderNode here = occluderNodes[node];
            bool met = meets(pencil, here.low, here.high);
            items = met ? here.items : 0;
            node = met ? node + 1 : here.next;
            --most;
        }
        for (int i = items >> 3; i < (items >> 3) + (items & 7); ++i) {
            Facet facet;
            if (facetOf(occluderTriangles[i], target, facet) && mayTake(facet, pencil)) foundTriangles[foundCount++] = i;
        }
    }
}

bool sawAll(int node) { return node >= occluderNodes.length(); }

// Software GL ends all loops of an invocation, without a word, when they have gone round 65,535 times. A pencil so wide that
// it meets more nodes than this is asked ray by ray.
const int mostNodes = 1024;

// Whether something may take rays of the pencil. Where that is more than is found, foundCount is mostFound.
bool mayBeTaken(Pencil pencil, Target target) {
    int node = 0;
    findTriangles(node, pencil, target, mostNodes);
    if (!sawAll(node)) foundCount = mostFound;
    return foundCount > 0;
}

// What the triangles found leave of a ray's light, by channel.
vec3 passingFound(vec3 from, vec3 to, Target target) {
    vec3 share = vec3(1.0);
    for (int i = 0; i < foundCount && share != vec3(0.0); ++i) {
        OccluderTriangle triangle = occluderTriangles[foundTriangles[i]];
        Facet facet;
        vec3 at;
        if (facetOf(triangle, target, facet) && takes(facet, from, to, at)) share *= passingTriangle(triangle, facet, at);
    }
    return share;
}

// What all triangles leave of it.
vec3 passingRay(vec3 from, vec3 to, Target target) {
    Pencil ray = pencilOf(mat4x3(from, from, from, from), mat4x3(to, to, to, to), vec3(0.0));
    vec3 share = vec3(1.0);
    int node = 0;
    do {
        findTriangles(node, ray, target, mostNodes);
        share *= passingFound(from, to, target);
    } while (share != vec3(0.0) && !sawAll(node));
    return share;
}
