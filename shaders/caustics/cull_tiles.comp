// Which tiles of the water's grid may send a beam to a map; one invocation a tile. A tile is left out only where the bounds
// of its rays, between the least depth and the greatest, lie outside of the map.
// In: bounds of the tiles; depths of the map's planes (levelmap/PlaneDepths.h), or with LEANING depths as exact beams
// count them (caustics/TangentPlanes.h). Out: list of the tiles, as work groups of an indirect
// dispatch; beams in them; marks of the tiles that are reached.
#include "interface/bindings.glsl"
#include "caustics/beam_limits.glsl"
#include "caustics/beam_tiles.glsl"
#include "levelmap/box.glsl"
#include "interface/kept_tiles.glsl"
layout(local_size_x = 64) in;
layout(binding = depthPyramidUnit) uniform sampler2D depthPyramid; // RGBA32F, m: x, y of its last level: least and greatest depth of all
layout(std430, binding = tileBoundsBuffer) readonly buffer Tiles { RayBounds bounds[]; };
layout(std430, binding = reachedTilesBuffer) writeonly buffer Reached { uint reached[]; };
layout(location = quadsLocation) uniform ivec2 quads;

// Numbers that are known to lie between two. All is in m, along the box's axes.
vec2 alongAxis(vec3 axis, vec3 low, vec3 high) {
    vec3 a = axis * low, b = axis * high;
    return vec2(dot(min(a, b), vec3(1.0)), dot(max(a, b), vec3(1.0)));
}
vec2 product(vec2 a, vec2 b) {
    vec4 c = vec4(a.x * b, a.y * b);
    return vec2(min(min(c.x, c.y), min(c.z, c.w)), max(max(c.x, c.y), max(c.z, c.w)));
}
vec2 quotient(vec2 a, vec2 positive) {
    return vec2(a.x / (a.x < 0.0 ? positive.x : positive.y), a.y / (a.y < 0.0 ? positive.y : positive.x));
}
vec2 scaled(vec2 a, float by) { return by < 0.0 ? by * a.yx : by * a; }

// The rays of a tile.
struct Rays {
    vec2 fromU, fromW, start; // at the surface: along u, along w, depth
    vec2 slopeU, slopeW;      // how they move by depth
};

// Whether they may be within the map. A texel of slack for rounding, and for corners that snap to a grid.
bool mayLieIn(vec2 u, vec2 w) {
    vec2 extent = vec2(boxSize.xy) * boxExtent.w;
    float slackU = boxExtent.w + 1e-4 * max(abs(u.x), abs(u.y)), slackW = boxExtent.w + 1e-4 * max(abs(w.x), abs(w.y));
    return u.y >= -slackU && u.x <= extent.x + slackU && w.y >= -slackW && w.x <= extent.y + slackW;
}

// Somewhere between two depths.
bool mayCross(Rays rays, vec2 depths) {
    vec2 way = vec2(depths.x - rays.start.y, depths.y - rays.start.x);
    return mayLieIn(rays.fromU + product(rays.slopeU, way), rays.fromW + product(rays.slopeW, way));
}

#ifdef LEANING
// As the pass over quads looks for them: on planes that lean as the receiver does (beam_quads.glsl, lean and settle).
// Sets `front`, how much they come from before those planes.
bool mayCrossLeaning(Rays rays, vec2 depths, out float front) {
    vec2 fronts = 1.0 - (scaled(rays.slopeU, boxShear.x) + scaled(rays.slopeW, boxShear.y)).yx;
    front = fronts.x;
    if (fronts.y < grazing) return false;
    fronts.x = max(fronts.x, grazing);
    vec2 back = -rays.start.yx; // to depth 0
    vec2 u = rays.fromU + product(rays.slopeU, back), w = rays.fromW + product(rays.slopeW, back);
    vec2 way = depths + scaled(u, boxShear.x) + scaled(w, boxShear.y);
    return mayLieIn(u + product(quotient(rays.slopeU, fronts), way), w + product(quotient(rays.slopeW, fronts), way));
}
#endif

bool mayReach(RayBounds b, vec2 depths) {
    if (depths.x > depths.y) return false;
    vec2 along = alongAxis(boxT.xyz, b.directionLow.xyz, b.directionHigh.xyz);
    // Rays nearly across the box: nothing can be said of where they go.
    if (along.x < 0.03) return true;
    vec3 low = b.originLow.xyz - boxCorner.xyz, high = b.originHigh.xyz - boxCorner.xyz;
    Rays rays;
    rays.fromU = alongAxis(boxU.xyz, low, high), rays.fromW = alongAxis(boxW.xyz, low, high);
    rays.start = alongAxis(boxT.xyz, low, high);
    rays.slopeU = quotient(alongAxis(boxU.xyz, b.directionLow.xyz, b.directionHigh.xyz), along);
    rays.slopeW = quotient(alongAxis(boxW.xyz, b.directionLow.xyz, b.directionHigh.xyz), along);
#ifdef LEANING
    float front;
    if (mayCrossLeaning(rays, depths, front)) return true;
    // Light along the receiver is looked for all through the box, and as far beyond as a texel's plane may reach
    // (slabAlong).
    float reach = 8.0 * boxExtent.w;
    return front < 1.01 * grazing && mayCross(rays, vec2(-reach, boxExtent.z + reach));
#else
    return mayCross(rays, depths);
#endif
}

void main() {
    int tile = int(gl_GlobalInvocationID.y * gl_NumWorkGroups.x * gl_WorkGroupSize.x + gl_GlobalInvocationID.x);
    ivec2 tiles = tilesOf(quads);
    if (tile >= tiles.x * tiles.y) return;
    vec2 depths = texelFetch(depthPyramid, ivec2(0), textureQueryLevels(depthPyramid) - 1).xy;
    if (!mayReach(bounds[tile], depths)) return;
    uint number = atomicAdd(keptTiles, 1u);
    kept[number] = uint(tile);
    atomicMax(keptGroups[0], min(number + 1u, 65535u));
    atomicMax(keptGroups[1], number / 65535u + 1u);
    ivec2 size = min(quads - firstQuad(tile, quads), ivec2(tileQuads));
    atomicAdd(keptBeams, uint(2 * size.x * size.y));
    reached[tile] = 1u;
}
