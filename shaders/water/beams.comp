// One ray into the water for each vertex of the surface.
// In: position and normal of the vertices. Out: origin (m, w = Fresnel transmittance) and unit direction below
// the surface (w = 0). A vertex whose normal faces away from the light transmits nothing.
#include "interface/bindings.glsl"
#include "water/light.glsl"
layout(local_size_x = 64) in;
layout(std430, binding = positionsBuffer) readonly buffer Positions { vec4 positions[]; };
layout(std430, binding = normalsBuffer) readonly buffer Normals { vec4 normals[]; };
layout(std430, binding = beamOriginsBuffer) writeonly buffer BeamOrigins { vec4 origins[]; };
layout(std430, binding = beamDirectionsBuffer) writeonly buffer BeamDirections { vec4 directions[]; };
layout(location = vertexCountLocation) uniform int vertexCount;

void main() {
    uint index = gl_GlobalInvocationID.y * gl_NumWorkGroups.x * gl_WorkGroupSize.x + gl_GlobalInvocationID.x;
    if (index >= uint(vertexCount)) return;
    vec3 position = positions[index].xyz;
    vec3 normal = normals[index].xyz;
    vec3 incident = incidentDirection(position);
    float eta = 1.0 / waterSurface.y;
    float cosIncident = -dot(incident, normal);
    origins[index] = vec4(position, fresnelTransmittance(cosIncident, eta));
    directions[index] = vec4(cosIncident > 0.0 ? refractDirection(incident, normal, eta) : incident, 0.0);
}
