// Adds what the water scatters to the picture, smoothed by a few taps that turn from sample to sample (Papadopoulos and
// Papaioannou 2009, 3.5). Where the target is coarser than the picture, a sample takes texels whose depth is its own: what
// lies before and behind an edge is not mixed.
// In: RGBA32F, of any size, W/(m² sr) and in alpha 1 over the metres along the view to what ends it (0: nothing); depth of
// the picture. Out: radiance, added.
#include "interface/bindings.glsl"
layout(binding = godraysUnit) uniform sampler2D godrays;
layout(binding = viewDepthUnit) uniform sampler2D depth; // 1 at the near plane, 0 far away
layout(location = samplesLocation) uniform ivec2 samples;      // of the picture
layout(location = tapsLocation) uniform int taps;              // 0: no filter
layout(location = radiusLocation) uniform float radius;        // texels of `godrays`
layout(location = nearLocation) uniform float near;            // m
out vec4 outRadiance;

const float tau = 6.28318530717958648;
// Share of the depth by which a texel may differ and still count half.
const float likeness = 0.03;
const float unlike = 1e-4; // weight of what lies elsewhere, for where nothing lies here

vec4 weighted(ivec2 texel, float here, float weight) {
    vec4 there = texelFetch(godrays, clamp(texel, ivec2(0), textureSize(godrays, 0) - 1), 0);
    float apart = (there.a - here) / (likeness * max(max(here, there.a), 1e-9));
    weight *= 1.0 / (1.0 + apart * apart) + unlike;
    return vec4(there.rgb, 1.0) * weight;
}

void main() {
    ivec2 size = textureSize(godrays, 0), finer = samples / size;
    if (taps == 0 && finer * size == samples) { // pixel by pixel, there is nothing to be smoothed
        outRadiance = vec4(texelFetch(godrays, ivec2(gl_FragCoord.xy) / finer, 0).rgb, 0.0);
        return;
    }
    float here = texelFetch(depth, ivec2(gl_FragCoord.xy), 0).x / near;
    vec2 at = gl_FragCoord.xy / vec2(samples) * vec2(size) - 0.5;
    vec2 base = floor(at), part = at - base;
    vec4 sum = vec4(0.0);
    for (int i = 0; i < 4; ++i) {
        vec2 share = mix(1.0 - part, part, vec2(i & 1, i >> 1));
        sum += weighted(ivec2(base) + ivec2(i & 1, i >> 1), here, share.x * share.y);
    }
    uvec2 seed = uvec2(gl_FragCoord.xy);
    uint h = seed.x * 0x8da6b343u ^ seed.y * 0xd8163841u;
    h = (h ^ (h >> 15u)) * 0x2c1b3c6du;
    h = (h ^ (h >> 12u)) * 0x297a2d39u;
    float turn = float(h >> 8u) * (tau / 16777216.0);
    for (int i = 0; i < taps; ++i) {
        float angle = turn + 2.39996322972865332 * float(i); // Vogel 1979
        vec2 aside = radius * sqrt((float(i) + 0.5) / float(taps)) * vec2(cos(angle), sin(angle));
        sum += weighted(ivec2(floor(at + aside + 0.5)), here, 1.0);
    }
    outRadiance = vec4(sum.rgb / sum.a, 0.0);
}
