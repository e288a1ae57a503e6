#version 450 core
// The host's own water: a few sines that travel as deep water's do. Any other simulation would do.
layout(local_size_x = 8, local_size_y = 8) in;
layout(r32f, binding = 0) writeonly uniform image2D heights; // m
layout(location = 0) uniform float seconds;
layout(location = 1) uniform vec2 size; // m, of the texture along x and z
layout(location = 2) uniform int waveCount;
layout(location = 4) uniform vec4 waves[8]; // wave vector along x and z, 1/m; amplitude, m; 1/s

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy), texels = imageSize(heights);
    if (any(greaterThanEqual(texel, texels))) return;
    vec2 place = size * ((vec2(texel) + 0.5) / vec2(texels) - 0.5);
    float height = 0.0;
    for (int i = 0; i < waveCount; ++i)
        height += waves[i].z * cos(dot(waves[i].xy, place) - waves[i].w * seconds);
    imageStore(heights, texel, vec4(height));
}
