// What a beam is cut with at each texel: the receiver's own tangent plane there.
// In: position map RG32F, normal map RG16 (level_map.frag).
// Out 0, RGBA32F: depth of the surface at the texel's centre, m (1e30: no receiver); how that depth grows by a texel
//        to the right and down, m; which of its places show that surface (rim.glsl).
// Out 1, RGBA32F, the finest level of the depth pyramid: least and greatest depth of the plane within the texel, less
//        what the receiver leans (boxShear), m (1e30, -1e30: no receiver); -1 at a rim, else 0; 0.
// RIMS: something may hide part of a texel; else all texels show one surface each.
#include "interface/bindings.glsl"
#include "levelmap/box.glsl"
#include "optics/octahedral.glsl"
#include "caustics/rim.glsl"
#ifdef RIMS
#include "water/light.glsl"
#include "occlusion/occluders.glsl"
#include "levelmap/same_surface.glsl"
layout(location = receiverNumberLocation) uniform int receiverNumber;
#endif
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = positionMapUnit) uniform sampler2D positionMap;
layout(binding = normalMapUnit) uniform sampler2D normalMap;
layout(rgba32f, binding = tangentPlanesImage) uniform writeonly image2D tangentPlanes;
layout(rgba32f, binding = depthPyramidImage) uniform writeonly image2D depthRange;

// A face steeper than this against the map has its light from its neighbours: a texel then spans 1000 of its widths.
const float leastFacing = 1e-3;

// Of the position map: whether the texel shows the receiver, from outside.
bool isThere(vec2 position) { return position.y != -1.0 && position.y != -3.0; }

vec3 normalOf(ivec2 texel) { return octahedralDecode(texelFetch(normalMap, texel, 0).xy); }

#ifdef RIMS
// The surface at the texel's middle.
struct Middle {
    ivec2 texel;
    float depth;
    vec2 gradient;
};

// In texels of the map.
vec3 placeOn(Middle middle, vec2 place) {
    return vec3(place * boxExtent.w, middle.depth + dot(middle.gradient, place - vec2(middle.texel) - 0.5) * boxExtent.w);
}

bool isAbove(vec3 place) { return boxPoint(place).y > waterSurface.x; }

// Whether a face so much nearer than the middle's, m, is not where that one goes on to.
bool standsOut(float nearer, vec2 gradient, vec2 other) {
    float crease = distance(gradient, other);
    return nearer > (crease > mostCrease ? 0.0 : creaseSlack(crease));
}

// Whether a place of the texel may show something else: what is beside it stands out, or the water ends.
bool mayBeRim(Middle middle) {
    vec2 rise = vec2(boxU.y, boxW.y) + boxT.y * middle.gradient;
    if (boxPoint(placeOn(middle, vec2(middle.texel) + 0.5)).y + 0.5 * boxExtent.w * (abs(rise.x) + abs(rise.y)) > waterSurface.x) return true;
    for (int i = 0; i < 4; ++i) {
        vec2 way = (i & 1) == 0 ? vec2(i - 1, 0.0) : vec2(0.0, i - 2);
        ivec2 beside = middle.texel + ivec2(way);
        if (any(lessThan(beside, ivec2(0))) || any(greaterThanEqual(beside, boxSize.xy))) continue;
        vec2 position = texelFetch(positionMap, beside, 0).xy;
        if (!isThere(position) || position.x >= placeOn(middle, vec2(beside) + 0.5).z) continue;
        vec2 gradient = depthGradient(normalOf(beside));
        float edge = middle.depth + dot(middle.gradient, 0.5 * way) * boxExtent.w;
        if (standsOut(edge - position.x + dot(gradient, 0.5 * way) * boxExtent.w, middle.gradient, gradient)) return true;
    }
    return false;
}

// Whether the map shows the face at all.
bool isShown(OccluderTriangle triangle, vec3 normal) { return triangle.receiver == receiverNumber && triangle.veil < 0 && belongsToMap(normal); }

vec2 placeIn(Middle middle, int place) {
    return vec2(middle.texel) + (vec2(place % rimPlaces, place / rimPlaces) + 0.5) / float(rimPlaces);
}

// Light along the map to a place of it.
void rayTo(vec3 place, out vec3 from, out vec3 to) { to = boxPoint(place), from = boxPoint(vec3(place.xy, -0.1 * boxExtent.z - boxExtent.w)); }

// Those of the places before which the triangle stands.
int hiddenBy(Middle middle, Facet facet, int places) {
    vec2 gradient = depthGradient(facet.normal);
    int hidden = 0;
    for (int i = 0; i < rimPlaces * rimPlaces; ++i) {
        if ((places >> i & 1) == 0) continue;
        vec3 place = placeOn(middle, placeIn(middle, i)), from, to, at;
        rayTo(place, from, to);
        if (!takes(facet, from, to, at) || at.y > waterSurface.x) continue;
        if (standsOut(place.z - boxLocal(at).z, middle.gradient, gradient)) hidden |= 1 << i;
    }
    return hidden;
}

// The same of all triangles.
int hiddenPlaces(Middle middle, int places) {
    mat4x3 from, to;
    for (int i = 0; i < 4; ++i) rayTo(placeOn(middle, vec2(middle.texel) + vec2(i & 1, i >> 1)), from[i], to[i]);
    Target target = targetOf(-1, vec2(0.0), vec3(0.0)); // all triangles count, right before its end
    Pencil pencil = pencilOf(from, to, vec3(0.0));
    int hidden = 0, node = 0;
    do {
        findTriangles(node, pencil, target, mostNodes);
        for (int i = 0; i < foundCount; ++i) {
            OccluderTriangle triangle = occluderTriangles[foundTriangles[i]];
            Facet facet;
            if (facetOf(triangle, target, facet) && isShown(triangle, facet.normal)) hidden |= hiddenBy(middle, facet, places & ~hidden);
        }
    } while (!sawAll(node) && hidden != places);
    return hidden;
}

int shownOf(Middle middle) {
    if (!mayBeRim(middle)) return allPlaces;
    int shown = 0;
    for (int i = 0; i < rimPlaces * rimPlaces; ++i)
        if (!isAbove(placeOn(middle, placeIn(middle, i)))) shown |= 1 << i;
    shown &= ~hiddenPlaces(middle, shown);
    return shown != 0 ? shown : allPlaces;
}
#endif

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(texel, boxSize.xy))) return;
    vec2 position = texelFetch(positionMap, texel, 0).xy;
    if (!isThere(position)) {
        imageStore(tangentPlanes, texel, vec4(1e30, 0.0, 0.0, float(allPlaces)));
        imageStore(depthRange, texel, vec4(1e30, -1e30, 0.0, 0.0));
        return;
    }
    vec3 facing = normalOf(texel), normal = boxDirection(facing);
    vec2 rise = normal.xy * (boxExtent.w / max(-normal.z, leastFacing));
    // What the normal's 16 bits cannot tell from none is none: floors across the light stay exactly so.
    rise *= step(vec2(1e-4 * boxExtent.w), abs(rise));
    vec2 lean = boxShear.xy * boxExtent.w, beside = abs(rise - lean);
    float reach = min(0.5 * (beside.x + beside.y), boxExtent.z);
    float upright = position.x - dot(lean, vec2(texel) + 0.5);
    int shown = allPlaces;
#ifdef RIMS
    shown = shownOf(Middle(texel, position.x, depthGradient(facing)));
#endif
    imageStore(tangentPlanes, texel, vec4(position.x, rise, float(shown)));
    imageStore(depthRange, texel, vec4(upright - reach, upright + reach, shown == allPlaces ? 0.0 : -1.0, 0.0));
}
