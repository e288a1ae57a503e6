// The quad of an invocation in a pass with one work group a tile of quads: over all tiles of the grid, or over those that
// cull_tiles.comp has kept.
#include "interface/bindings.glsl"
#include "caustics/beam_tiles.glsl"
#include "interface/kept_tiles.glsl"
layout(location = culledLocation) uniform int culled; // 0: all tiles

// The tile of this work group, -1 for none.
int workTile() {
    int group = int(gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x);
    if (culled == 0) return group;
    return group < int(keptTiles) ? int(kept[group]) : -1;
}

// False where there is none for this invocation of 64.
bool workQuad(ivec2 quads, out ivec2 at) {
    int tile = workTile(), within = int(gl_LocalInvocationIndex);
    at = firstQuad(max(tile, 0), quads) + ivec2(within % tileQuads, within / tileQuads);
    return tile >= 0 && all(lessThan(at, quads));
}
