// One beam: refracted at its corners, its flux added to the texel that its middle falls on.
// In: indices, positions, normals. Out: flux by texel, in units.
#include "../bench/shaders/yardstick.glsl"
layout(local_size_x = 64) in;
layout(std430, binding = indicesBuffer) readonly buffer Indices { uint indices[]; };
layout(std430, binding = positionsBuffer) readonly buffer Positions { vec4 positions[]; };
layout(std430, binding = normalsBuffer) readonly buffer Normals { vec4 normals[]; };
layout(std430, binding = fluxSumsBuffer) buffer Map { uint map[]; };
layout(location = triangleCountLocation) uniform int triangleCount;
layout(location = wattsPerStepLocation) uniform float wattsPerStep; // for 1 W/m²

void main() {
    uint index = gl_GlobalInvocationID.y * gl_NumWorkGroups.x * gl_WorkGroupSize.x + gl_GlobalInvocationID.x;
    if (index >= uint(triangleCount)) return;
    vec3 p[3];
    vec2 middle = vec2(0.0);
    for (int i = 0; i < 3; ++i) {
        uint corner = indices[3 * index + uint(i)];
        p[i] = positions[corner].xyz;
        middle += texelOf(p[i], refracted(p[i], normals[corner].xyz)) / 3.0;
    }
    ivec2 texel = ivec2(floor(middle));
    if (any(lessThan(texel, ivec2(0))) || any(greaterThanEqual(texel, boxSize.xy))) return;
    float flux = -0.5 * dot(cross(p[1] - p[0], p[2] - p[0]), lightDirection.xyz);
    atomicAdd(map[texel.y * boxSize.x + texel.x], uint(max(flux, 0.0) / wattsPerStep + 0.5));
}
