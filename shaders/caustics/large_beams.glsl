// Leaves a part of a beam to many invocations.
#include "interface/large_beams.glsl"

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
