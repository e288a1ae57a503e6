// The beams of a light seen from a receiver's box (footprint.glsl): found once here, read by every plane.
// TILES: of the corners of some tiles of quads only.
// In: beam origins, directions. Out: (at, slope) in texels and texels per metre; depth of the origin, m.
#include "interface/bindings.glsl"
#include "caustics/footprint.glsl"
#ifdef TILES
#include "caustics/tile_quads.glsl"
#endif
layout(local_size_x = 64) in;
layout(std430, binding = beamOriginsBuffer) readonly buffer BeamOrigins { vec4 origins[]; };
layout(std430, binding = beamDirectionsBuffer) readonly buffer BeamDirections { vec4 directions[]; };
layout(std430, binding = footprintsBuffer) writeonly buffer Footprints { vec4 footprints[]; };
layout(std430, binding = originDepthsBuffer) writeonly buffer OriginDepths { float originDepths[]; };
#ifdef TILES
layout(location = quadsLocation) uniform ivec2 quads;
#else
layout(location = vertexCountLocation) uniform int vertexCount;
#endif

void look(int index) {
    vec3 origin = boxLocal(origins[index].xyz);
    footprints[index] = rayFootprint(origin, boxDirection(directions[index].xyz));
    originDepths[index] = origin.z;
}

#ifdef TILES
// Corners that tiles share are looked at by each of them, with the same result.
void main() {
    int tile = workTile();
    if (tile < 0) return;
    ivec2 first = firstQuad(tile, quads), corners = min(quads - first, ivec2(tileQuads)) + 1;
    if (any(lessThan(corners, ivec2(2)))) return;
    for (int i = int(gl_LocalInvocationIndex); i < corners.x * corners.y; i += int(gl_WorkGroupSize.x)) {
        ivec2 at = first + ivec2(i % corners.x, i / corners.x);
        look(at.y * (quads.x + 1) + at.x);
    }
}
#else
void main() {
    int index = int(gl_GlobalInvocationID.y * gl_NumWorkGroups.x * gl_WorkGroupSize.x + gl_GlobalInvocationID.x);
    if (index < vertexCount) look(index);
}
#endif
