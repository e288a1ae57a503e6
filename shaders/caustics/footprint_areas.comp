// Cross-section of each beam perpendicular to the box's axis: twice its signed area at depth z is
// c0 + c1 z + c2 z², in texels.
// In: indices, footprints, flux. Out: (c0, c1, c2, flux).
#include "include/box.glsl"
layout(local_size_x = 64) in;
layout(std430, binding = 0) readonly buffer Indices { uint indices[]; };
layout(std430, binding = 5) readonly buffer BeamFlux { float flux[]; };
layout(std430, binding = 6) readonly buffer Footprints { vec4 footprints[]; };
layout(std430, binding = 8) writeonly buffer BeamAreas { vec4 areas[]; };
layout(location = 0) uniform int triangleCount;

float cross2(vec2 a, vec2 b) { return a.x * b.y - a.y * b.x; }

void main() {
    uint index = gl_GlobalInvocationID.y * gl_NumWorkGroups.x * gl_WorkGroupSize.x + gl_GlobalInvocationID.x;
    if (index >= uint(triangleCount)) return;
    vec4 a = footprints[indices[3 * index]];
    vec4 e = footprints[indices[3 * index + 1]] - a, f = footprints[indices[3 * index + 2]] - a;
    bool met = max(abs(a.z), max(abs(a.z + e.z), abs(a.z + f.z))) * boxExtent.w < 1e5;
    areas[index] = vec4(cross2(e.xy, f.xy), cross2(e.xy, f.zw) + cross2(e.zw, f.xy), cross2(e.zw, f.zw), met ? flux[index] : 0.0);
}
