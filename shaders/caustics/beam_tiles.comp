// Bounds of a light's rays by tiles of the water's grid; one invocation a tile.
// In: beam origins, directions. Out: bounds (beam_tiles.glsl); marks of reached tiles, all cleared.
#include "interface/bindings.glsl"
#include "caustics/beam_tiles.glsl"
layout(local_size_x = 64) in;
layout(std430, binding = tileBoundsBuffer) writeonly buffer Tiles { RayBounds bounds[]; };
layout(std430, binding = reachedTilesBuffer) writeonly buffer Reached { uint reached[]; };
layout(std430, binding = beamOriginsBuffer) readonly buffer BeamOrigins { vec4 origins[]; };
layout(std430, binding = beamDirectionsBuffer) readonly buffer BeamDirections { vec4 directions[]; };
layout(location = quadsLocation) uniform ivec2 quads;

void main() {
    int tile = int(gl_GlobalInvocationID.y * gl_NumWorkGroups.x * gl_WorkGroupSize.x + gl_GlobalInvocationID.x);
    ivec2 tiles = tilesOf(quads);
    if (tile >= tiles.x * tiles.y) return;
    ivec2 first = firstQuad(tile, quads), last = min(first + tileQuads, quads);
    RayBounds b = RayBounds(vec4(1e30), vec4(-1e30), vec4(1e30), vec4(-1e30));
    for (int z = first.y; z <= last.y; ++z)
        for (int x = first.x; x <= last.x; ++x) {
            vec4 origin = origins[z * (quads.x + 1) + x], direction = directions[z * (quads.x + 1) + x];
            b.originLow = min(b.originLow, origin), b.originHigh = max(b.originHigh, origin);
            b.directionLow = min(b.directionLow, direction), b.directionHigh = max(b.directionHigh, direction);
        }
    bounds[tile] = b;
    reached[tile] = 0u;
}
