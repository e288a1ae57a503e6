// The beams of a light seen from a receiver's box (footprint.glsl): found once here, read by every plane.
// In: beam origins, directions. Out: (at, slope) in texels and texels per metre; depth of the origin, m.
#include "include/footprint.glsl"
layout(local_size_x = 64) in;
layout(std430, binding = 3) readonly buffer BeamOrigins { vec4 origins[]; };
layout(std430, binding = 4) readonly buffer BeamDirections { vec4 directions[]; };
layout(std430, binding = 6) writeonly buffer Footprints { vec4 footprints[]; };
layout(std430, binding = 7) writeonly buffer OriginDepths { float originDepths[]; };
layout(location = 0) uniform int vertexCount;

void main() {
    uint index = gl_GlobalInvocationID.y * gl_NumWorkGroups.x * gl_WorkGroupSize.x + gl_GlobalInvocationID.x;
    if (index >= uint(vertexCount)) return;
    vec3 origin = boxLocal(origins[index].xyz);
    footprints[index] = rayFootprint(origin, boxDirection(directions[index].xyz));
    originDepths[index] = origin.z;
}
