// Beams by tiles of the water's grid, so that those which cannot reach a map are culled many at a time.

// Quads along a side of a tile.
const int tileQuads = 8;

// Of the rays at the corners of a tile's quads.
struct RayBounds {
    vec4 originLow, originHigh;       // m from the scene's origin
    vec4 directionLow, directionHigh; // of the unit vectors, by component
};

ivec2 tilesOf(ivec2 quads) { return (quads + tileQuads - 1) / tileQuads; }
ivec2 firstQuad(int tile, ivec2 quads) {
    int across = tilesOf(quads).x;
    return tileQuads * ivec2(tile % across, tile / across);
}
