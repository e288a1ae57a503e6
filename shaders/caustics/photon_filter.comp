// The low-pass filter over splats (Papadopoulos and Papaioannou 2009, 3.5): a texel takes the mean irradiance of itself
// and a few taps around it that show the same surface; the taps turn from texel to texel.
// Texels to which no photon came but some were taken on their way lie in the shade: they stay dark and give nothing.
// In: sums of the splats and marks of shade behind them, level map. Out: filtered sums; behind those of the texels, for each channel, what the splats
// and what the filtered ones come to, so that resolving can give back what the mean took or added.
#include "interface/bindings.glsl"
#include "caustics/photon_place.glsl"
#include "interface/flux_sums.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(std430, binding = splatSumsBuffer) readonly buffer SplatSums { uint splats[]; };
layout(location = channelsLocation) uniform int channels;
layout(location = tapsLocation) uniform int taps;
layout(location = radiusLocation) uniform float radius;       // texels
layout(location = shadeMarksLocation) uniform int shadeMarks; // word of `splats` where marks of shaded texels begin

const float tau = 6.28318530717958648;
shared vec3 before[64], after[64];

// Evenly spread over the disc (Vogel 1979), turned by the texel's own angle.
ivec2 tap(ivec2 texel, int i) {
    uint h = uint(texel.x) * 0x8da6b343u ^ uint(texel.y) * 0xd8163841u;
    h = (h ^ (h >> 15u)) * 0x2c1b3c6du;
    h = (h ^ (h >> 12u)) * 0x297a2d39u;
    float angle = float(h >> 8u) * (tau / 16777216.0) + 2.39996322972865332 * float(i);
    return texel + ivec2(floor(radius * sqrt((float(i) + 0.5) / float(taps)) * vec2(cos(angle), sin(angle)) + 0.5));
}

vec3 splatAt(ivec2 texel) {
    vec3 sum = vec3(0.0);
    int index = channels * (texel.y * boxSize.x + texel.x);
    for (int c = 0; c < channels; ++c) sum[c] = float(splats[2 * (index + c)]) + 4294967296.0 * float(splats[2 * (index + c) + 1]);
    return sum;
}

bool isShaded(ivec2 texel, vec3 light) { return light == vec3(0.0) && splats[shadeMarks + texel.y * boxSize.x + texel.x] != 0u; }

// A texel's share of surface is larger where it is steep.
float facingAt(ivec2 texel) {
    return max(abs(dot(octahedralDecode(texelFetch(normalMap, texel, 0).xy), boxT.xyz)), leastFacing);
}

void filterTexel(ivec2 texel, uint number) {
    vec3 own = splatAt(texel);
    before[number] = own;
    TexelPlane plane = planeAt(texel);
    if (!plane.there || isShaded(texel, own)) return;
    float facing = facingAt(texel), count = 1.0;
    vec3 sum = own * facing;
    for (int i = 0; i < taps; ++i) {
        ivec2 at = tap(texel, i);
        if (!sameSurface(at, plane, texel, radius)) continue;
        vec3 light = splatAt(at);
        if (isShaded(at, light)) continue;
        sum += light * facingAt(at);
        count += 1.0;
    }
    after[number] = floor(sum / (count * facing) + 0.5);
    int index = channels * (texel.y * boxSize.x + texel.x);
    for (int c = 0; c < channels; ++c) addFlux(index + c, after[number][c]);
}

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    uint number = gl_LocalInvocationIndex;
    before[number] = after[number] = vec3(0.0);
    if (all(lessThan(texel, boxSize.xy))) filterTexel(texel, number);
    barrier();
    if (number != 0u) return;
    vec3 wholeBefore = vec3(0.0), wholeAfter = vec3(0.0);
    for (int i = 0; i < 64; ++i) wholeBefore += before[i], wholeAfter += after[i];
    int end = channels * boxSize.x * boxSize.y;
    for (int c = 0; c < channels; ++c) {
        addFlux(end + c, wholeBefore[c]);
        addFlux(end + channels + c, wholeAfter[c]);
    }
}
