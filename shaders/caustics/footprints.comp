// The beams of a light seen from a receiver's box. A vertex's ray meets depth z at `at + z · slope`, in texels of
// the receiver's maps, so a beam's cross-section area is a quadratic in z: found once here, read by every plane.
// In: beam origins, directions. Out: (at, slope) in texels and texels per metre; depth of the origin, m.
#include "include/box.glsl"
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
    vec3 direction = boxDirection(directions[index].xyz);
    // A ray that runs nearly across the box or backwards does not meet its planes in any useful place; the slope
    // marks it, and beams with such an edge carry nothing (footprint_areas.comp).
    vec2 slope = direction.z > 0.02 ? direction.xy / direction.z : vec2(1e6);
    vec2 at = origin.xy - slope * origin.z;
    footprints[index] = vec4(at, slope) / boxExtent.w;
    originDepths[index] = origin.z;
}
