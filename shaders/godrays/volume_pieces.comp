// How many pieces each illumination volume is cut into: none where there is no light, and where no part of it can be seen.
// In: rays and flux (illumination_volumes.comp). Out: counts.
#include "godrays/illumination_volume.glsl"
#include "interface/volume_starts.glsl"
layout(local_size_x = 64) in;

void main() {
    int number = int(gl_GlobalInvocationID.y * gl_NumWorkGroups.x * gl_WorkGroupSize.x + gl_GlobalInvocationID.x);
    if (number >= 2 * across.x * across.y) return;
    Volume volume = volumeAt(number);
    bool drawn = isLit(volume, number) && !isOutOfView(volume, volume.begin, volume.end);
    starts[number] = drawn ? uint(piecesOf(volume)) : 0u;
}
