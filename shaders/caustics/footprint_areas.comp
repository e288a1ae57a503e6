// Cross-section of each beam perpendicular to the box's axis (footprint.glsl), and its flux.
// In: indices, footprints, flux. Out: (c0, c1, c2, flux).
#include "interface/bindings.glsl"
#include "caustics/footprint.glsl"
layout(local_size_x = 64) in;
layout(std430, binding = indicesBuffer) readonly buffer Indices { uint indices[]; };
layout(std430, binding = beamFluxBuffer) readonly buffer BeamFlux { float flux[]; };
layout(std430, binding = footprintsBuffer) readonly buffer Footprints { vec4 footprints[]; };
layout(std430, binding = beamAreasBuffer) writeonly buffer BeamAreas { vec4 areas[]; };
layout(location = triangleCountLocation) uniform int triangleCount;

void main() {
    uint index = gl_GlobalInvocationID.y * gl_NumWorkGroups.x * gl_WorkGroupSize.x + gl_GlobalInvocationID.x;
    if (index >= uint(triangleCount)) return;
    vec4 a = footprints[indices[3 * index]], b = footprints[indices[3 * index + 1]], c = footprints[indices[3 * index + 2]];
    areas[index] = vec4(crossSection(a, b, c), meetsPlanes(a, b, c) ? flux[index] : 0.0);
}
