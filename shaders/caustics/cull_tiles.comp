// Which tiles of the water's grid may send a beam to the planes of a map; one invocation a tile. A tile is left out only
// where the bounds of its rays, between the first plane and the last, lie outside of the map.
// In: bounds of the tiles, plane depths (levelmap/PlaneDepths.h). Out: list of the tiles, as work groups of an indirect
// dispatch; beams in them; marks of the tiles that are reached.
#include "include/beam_tiles.glsl"
#include "include/box.glsl"
layout(local_size_x = 64) in;
layout(binding = 0) uniform sampler2D planeDepths; // RG32F, m
layout(std430, binding = 0) readonly buffer Tiles { RayBounds bounds[]; };
layout(std430, binding = 1) writeonly buffer Reached { uint reached[]; };
layout(std430, binding = 2) buffer Kept {
    uint groups[3]; // rows of 65,535 and how many rows
    uint tileCount;
    uint beamCount;
    uint kept[];
};
layout(location = 0) uniform ivec2 quads;

// Least and greatest product of an axis with the vectors between two.
vec2 alongAxis(vec3 axis, vec3 low, vec3 high) {
    vec3 a = axis * low, b = axis * high;
    return vec2(dot(min(a, b), vec3(1.0)), dot(max(a, b), vec3(1.0)));
}

vec2 product(vec2 a, vec2 b) {
    vec4 corners = vec4(a.x * b, a.y * b);
    return vec2(min(min(corners.x, corners.y), min(corners.z, corners.w)), max(max(corners.x, corners.y), max(corners.z, corners.w)));
}

// Whether rays between these bounds may cross [0, extent] along an axis while they go `depths` deep along a second.
bool mayCross(vec3 axis, RayBounds b, vec2 along, vec2 depths, float extent) {
    vec2 from = alongAxis(axis, b.originLow.xyz - boxCorner.xyz, b.originHigh.xyz - boxCorner.xyz);
    vec2 aside = alongAxis(axis, b.directionLow.xyz, b.directionHigh.xyz);
    vec2 slope = vec2(aside.x / (aside.x < 0.0 ? along.x : along.y), aside.y / (aside.y < 0.0 ? along.y : along.x));
    vec2 at = from + product(slope, depths);
    // A texel for rounding, and for corners that snap to a grid.
    float slack = boxExtent.w + 1e-4 * max(abs(at.x), abs(at.y));
    return at.y >= -slack && at.x <= extent + slack;
}

bool mayReach(RayBounds b, vec2 planes) {
    if (planes.x > planes.y) return false;
    vec2 along = alongAxis(boxT.xyz, b.directionLow.xyz, b.directionHigh.xyz);
    // Rays nearly across the box: nothing can be said of where they go.
    if (along.x < 0.03) return true;
    vec2 from = alongAxis(boxT.xyz, b.originLow.xyz - boxCorner.xyz, b.originHigh.xyz - boxCorner.xyz);
    vec2 depths = vec2(planes.x - from.y, planes.y - from.x);
    vec2 extent = vec2(boxSize.xy) * boxExtent.w;
    return mayCross(boxU.xyz, b, along, depths, extent.x) && mayCross(boxW.xyz, b, along, depths, extent.y);
}

void main() {
    int tile = int(gl_GlobalInvocationID.y * gl_NumWorkGroups.x * gl_WorkGroupSize.x + gl_GlobalInvocationID.x);
    ivec2 tiles = tilesOf(quads);
    if (tile >= tiles.x * tiles.y) return;
    vec2 planes = texelFetch(planeDepths, ivec2(0), textureQueryLevels(planeDepths) - 1).xy;
    if (!mayReach(bounds[tile], planes)) return;
    uint number = atomicAdd(tileCount, 1u);
    kept[number] = uint(tile);
    atomicMax(groups[0], min(number + 1u, 65535u));
    atomicMax(groups[1], number / 65535u + 1u);
    ivec2 size = min(quads - firstQuad(tile, quads), ivec2(tileQuads));
    atomicAdd(beamCount, uint(2 * size.x * size.y));
    reached[tile] = 1u;
}
