// Adds what the water scatters to the picture, smoothed by a few taps that turn from sample to sample (Papadopoulos and
// Papaioannou 2009, 3.5).
// In, RGBA32F, of any size: W/(m² sr). Out: the same, added.
layout(binding = 0) uniform sampler2D godrays;
layout(location = 0) uniform ivec2 samples; // of the picture
layout(location = 1) uniform int taps;      // 0: no filter
layout(location = 2) uniform float radius;  // texels of `godrays`
layout(location = 0) out vec4 outRadiance;

const float tau = 6.28318530717958648;

void main() {
    ivec2 size = textureSize(godrays, 0), finer = samples / size;
    if (taps == 0 && finer * size == samples) { // pixel by pixel, there is nothing to be smoothed
        outRadiance = vec4(texelFetch(godrays, ivec2(gl_FragCoord.xy) / finer, 0).rgb, 0.0);
        return;
    }
    vec2 uv = gl_FragCoord.xy / vec2(samples), texel = 1.0 / vec2(size);
    uvec2 at = uvec2(gl_FragCoord.xy);
    uint h = at.x * 0x8da6b343u ^ at.y * 0xd8163841u;
    h = (h ^ (h >> 15u)) * 0x2c1b3c6du;
    h = (h ^ (h >> 12u)) * 0x297a2d39u;
    float turn = float(h >> 8u) * (tau / 16777216.0);
    vec3 sum = texture(godrays, uv).rgb;
    for (int i = 0; i < taps; ++i) {
        float angle = turn + 2.39996322972865332 * float(i); // Vogel 1979
        sum += texture(godrays, uv + radius * sqrt((float(i) + 0.5) / float(taps)) * vec2(cos(angle), sin(angle)) * texel).rgb;
    }
    outRadiance = vec4(sum / float(taps + 1), 0.0);
}
