// The water surface at one time: a grid of (quads + 1) vertices a side over the patch.
// In: the waves, and the height maps with two frames each. Out: position (m from the scene's origin, w = 1) and unit
// normal of each vertex, row by row in z.
#include "interface/bindings.glsl"
#include "optics/spline.glsl"
#include "optics/waves.glsl"
layout(local_size_x = 64) in;
layout(std430, binding = wavesBuffer) readonly buffer Waves { WaveTerm waves[]; };
layout(std430, binding = positionsBuffer) writeonly buffer Positions { vec4 positions[]; };
layout(std430, binding = normalsBuffer) writeonly buffer Normals { vec4 normals[]; };
layout(location = patchMinLocation) uniform vec2 patchMin;   // m
layout(location = patchSizeLocation) uniform vec2 patchSize; // m
layout(location = quadsLocation) uniform ivec2 quads;
layout(location = levelLocation) uniform float level; // m
layout(location = waveCountLocation) uniform int waveCount;
layout(location = frameCountLocation) uniform int frameCount; // two for each height map
layout(location = heightMapPlacesLocation) uniform vec4 heightMapPlaces[4]; // corner x, z, m; texels a metre
layout(location = frameSharesLocation) uniform float frameShares[8]; // m for one unit
layout(location = tiledLocation) uniform int tiled[4]; // 1: the height map repeats without end
layout(location = hasLinesLocation) uniform int hasLines; // 0: quads are equally wide
layout(std430, binding = gridLinesBuffer) readonly buffer Lines { float lines[]; }; // between quads, m: all along x, then along z
layout(binding = heightFramesUnit) uniform sampler2D frames[8]; // coefficients of a bicubic B-spline

// Value and derivatives by texel of a frame at `at`, in texels from the corner of the first one. Outside of the
// texture it is 0, as the outermost coefficients are, or it begins again.
vec3 splineAt(int frame, vec2 at) {
    vec2 size = vec2(textureSize(frames[frame], 0));
    at = tiled[frame / 2] != 0 ? mod(at - 0.5, size) : clamp(at - 0.5, vec2(-1.0), size);
    vec2 base = floor(at);
    vec4 wx = splineWeights(at.x - base.x), dx = splineSlopes(at.x - base.x);
    vec4 wz = splineWeights(at.y - base.y), dz = splineSlopes(at.y - base.y);
    vec3 sum = vec3(0.0);
    for (int j = 0; j < 4; j += 2)
        for (int i = 0; i < 4; i += 2) {
            // Four at once: sixteen fetches from an array of samplers take Mesa's software driver 40 times as long
            // to compile.
            vec4 c = textureGather(frames[frame], (base + vec2(i, j)) / size);
            vec2 left = c.wx, right = c.zy; // columns i and i + 1, each in rows j and j + 1
            vec2 z = vec2(wz[j], wz[j + 1]), slopeZ = vec2(dz[j], dz[j + 1]);
            sum += vec3(dot(wx[i] * left + wx[i + 1] * right, z), dot(dx[i] * left + dx[i + 1] * right, z),
                        dot(wx[i] * left + wx[i + 1] * right, slopeZ));
        }
    return sum;
}

// Height in m, dy/dx, dy/dz of the height maps.
vec3 heightMapsAt(vec2 xz) {
    vec3 sum = vec3(0.0);
    for (int frame = 0; frame < frameCount; ++frame) {
        if (frameShares[frame] == 0.0) continue;
        vec4 place = heightMapPlaces[frame / 2];
        sum += frameShares[frame] * splineAt(frame, (xz - place.xy) * place.zw) * vec3(1.0, place.zw);
    }
    return sum;
}

void main() {
    int index = int(gl_GlobalInvocationID.y * gl_NumWorkGroups.x * gl_WorkGroupSize.x + gl_GlobalInvocationID.x);
    if (index >= (quads.x + 1) * (quads.y + 1)) return;
    ivec2 at = ivec2(index % (quads.x + 1), index / (quads.x + 1));
    vec2 xz = hasLines != 0 ? vec2(lines[at.x], lines[quads.x + 1 + at.y]) : patchMin + patchSize * vec2(at) / vec2(quads);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < waveCount; ++i) sum += waveHeightAndSlope(waves[i], xz);
    sum += heightMapsAt(xz);
    positions[index] = vec4(xz.x, level + sum.x, xz.y, 1.0);
    normals[index] = vec4(normalize(vec3(-sum.y, 1.0, -sum.z)), 0.0);
}
