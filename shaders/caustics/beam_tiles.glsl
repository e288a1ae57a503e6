// Beams by tiles of the water's grid, so that those which cannot reach a map are culled many at a time.

#include "interface/ray_bounds.glsl"

ivec2 tilesOf(ivec2 quads) { return (quads + tileQuads - 1) / tileQuads; }
ivec2 firstQuad(int tile, ivec2 quads) {
    int across = tilesOf(quads).x;
    return tileQuads * ivec2(tile % across, tile / across);
}
