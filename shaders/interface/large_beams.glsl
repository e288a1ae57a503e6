// Quads that touch more texels than one invocation should walk: left as tiles to a pass of many.
const int tileSide = 16;
// Of a tile: the quad, a number that the pass gave it, place of its first texel.
layout(std430, binding = 9) buffer LargeBeams {
    uvec3 tileGroups; // to dispatch: a work group a tile
    int tileCount;    // asked for; those beyond the buffer's end are not in it
    ivec4 tiles[];
};

// False where the buffer is full.
bool leaveToMany(int quad, int number, ivec2 low, ivec2 high) {
    ivec2 count = (high - low) / tileSide + 1;
    int first = atomicAdd(tileCount, count.x * count.y), end = first + count.x * count.y;
    bool fits = end <= tiles.length();
    atomicMax(tileGroups.x, uint(min(end, tiles.length())));
    for (int i = first; i < min(end, tiles.length()); ++i) {
        ivec2 tile = low + tileSide * ivec2((i - first) % count.x, (i - first) / count.x);
        tiles[i] = ivec4(fits ? quad : -1, number, tile);
    }
    return fits;
}
