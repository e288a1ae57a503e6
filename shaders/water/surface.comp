// The water surface at one time: a grid of (quads + 1) vertices a side over the patch.
// In: the waves. Out: position (m from the scene's origin, w = 1) and unit normal of each vertex, row by row in z.
#include "include/waves.glsl"
layout(local_size_x = 64) in;
layout(std430, binding = 0) readonly buffer Waves { WaveTerm waves[]; };
layout(std430, binding = 1) writeonly buffer Positions { vec4 positions[]; };
layout(std430, binding = 2) writeonly buffer Normals { vec4 normals[]; };
layout(location = 0) uniform vec2 patchMin;  // m
layout(location = 1) uniform vec2 patchSize; // m
layout(location = 2) uniform ivec2 quads;
layout(location = 3) uniform float level;    // m
layout(location = 4) uniform int waveCount;

void main() {
    int index = int(gl_GlobalInvocationID.y * gl_NumWorkGroups.x * gl_WorkGroupSize.x + gl_GlobalInvocationID.x);
    if (index >= (quads.x + 1) * (quads.y + 1)) return;
    ivec2 at = ivec2(index % (quads.x + 1), index / (quads.x + 1));
    vec2 xz = patchMin + patchSize * vec2(at) / vec2(quads);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < waveCount; ++i) sum += waveHeightAndSlope(waves[i], xz);
    positions[index] = vec4(xz.x, level + sum.x, xz.y, 1.0);
    normals[index] = vec4(normalize(vec3(-sum.y, 1.0, -sum.z)), 0.0);
}
