// One beam that is refracted already: its flux added to the texel that its middle falls on.
// In: indices, beam origins, directions and flux. Out: flux by texel, in units.
#include "../bench/shaders/yardstick.glsl"
layout(local_size_x = 64) in;
layout(std430, binding = indicesBuffer) readonly buffer Indices { uint indices[]; };
layout(std430, binding = beamOriginsBuffer) readonly buffer BeamOrigins { vec4 origins[]; };
layout(std430, binding = beamDirectionsBuffer) readonly buffer BeamDirections { vec4 directions[]; };
layout(std430, binding = beamFluxBuffer) readonly buffer BeamFlux { float flux[]; };
layout(std430, binding = fluxSumsBuffer) buffer Map { uint map[]; };
layout(location = triangleCountLocation) uniform int triangleCount;
layout(location = wattsPerStepLocation) uniform float wattsPerStep; // for 1 W/m²

void main() {
    uint index = gl_GlobalInvocationID.y * gl_NumWorkGroups.x * gl_WorkGroupSize.x + gl_GlobalInvocationID.x;
    if (index >= uint(triangleCount)) return;
    vec2 middle = vec2(0.0);
    for (int i = 0; i < 3; ++i) {
        uint corner = indices[3 * index + uint(i)];
        middle += texelOf(origins[corner].xyz, directions[corner].xyz) / 3.0;
    }
    ivec2 texel = ivec2(floor(middle));
    if (any(lessThan(texel, ivec2(0))) || any(greaterThanEqual(texel, boxSize.xy))) return;
    atomicAdd(map[texel.y * boxSize.x + texel.x], uint(flux[index] / wattsPerStep + 0.5));
}
