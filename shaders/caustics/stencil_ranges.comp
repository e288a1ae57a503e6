// Which sub-volumes of a beam may hold something of a receiver: of Iwasaki et al. (2002, 4.3) the volumes that meet an
// object's bounding box; here those that meet the depths of what lies within their own.
// In: indices, footprints, areas, plane pyramid. Out, a beam: number of its first sub-volume, and how many; of the
// draw, the instances: the most that a beam has.
#include "interface/bindings.glsl"
#include "interface/draw_command.glsl"
#include "caustics/sub_volumes.glsl"
layout(local_size_x = 64) in;
layout(std430, binding = indicesBuffer) readonly buffer Indices { uint indices[]; };
layout(std430, binding = footprintsBuffer) readonly buffer Footprints { vec4 footprints[]; };
layout(std430, binding = beamAreasBuffer) readonly buffer BeamAreas { vec4 areas[]; };
layout(std430, binding = rangesBuffer) writeonly buffer Ranges { ivec2 ranges[]; };
layout(location = beamCountLocation) uniform int beamCount;

// Asked for again within what was found until it settles.
ivec2 subVolumesMet(vec4 a, vec4 b, vec4 c) {
    ivec2 met = subVolumesOf(texelFetch(depthPyramid, ivec2(0), textureQueryLevels(depthPyramid) - 1).xy);
    for (int i = 0; i < 4 && met.x <= met.y; ++i) {
        ivec2 found = subVolumesWithin(a, b, c, vec2(subVolume(met.x).x, subVolume(met.y).y));
        found = ivec2(max(found.x, met.x), min(found.y, met.y));
        if (found == met) break;
        met = found;
    }
    return met;
}

void main() {
    int beam = int(gl_GlobalInvocationID.y * gl_NumWorkGroups.x * gl_WorkGroupSize.x + gl_GlobalInvocationID.x);
    if (beam >= beamCount) return;
    ranges[beam] = ivec2(0);
    if (!(areas[beam].w > 0.0)) return;
    ivec2 met = subVolumesMet(footprints[indices[3 * beam]], footprints[indices[3 * beam + 1]], footprints[indices[3 * beam + 2]]);
    if (met.x > met.y) return;
    ranges[beam] = ivec2(met.x, met.y - met.x + 1);
    atomicMax(instances, uint(met.y - met.x + 1));
}
