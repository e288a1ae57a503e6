// Coefficients of the bicubic B-spline through a host's heights, in two passes, one along each axis: the filter
// √3 z^|k|, z = √3 − 2 (Unser, Aldroubi and Eden 1993), whose ninth term is 7e-6 of the first. Heights are mirrored in
// the texture's edges.
#include "interface/bindings.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(location = axisLocation) uniform int axis;                  // 0: x, 1: z
layout(binding = hostHeightsUnit) uniform sampler2D heights; // after those of surface.comp
layout(r32f, binding = coefficientsImage) writeonly uniform image2D coefficients;

int mirrored(int i, int count) { return i < 0 ? -1 - i : i >= count ? 2 * count - 1 - i : i; }

float heightAt(ivec2 texel, int offset, ivec2 size) {
    texel[axis] = mirrored(texel[axis] + offset, size[axis]);
    return texelFetch(heights, texel, 0).x;
}

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    ivec2 size = imageSize(coefficients);
    if (any(greaterThanEqual(texel, size))) return;
    const float z = -0.267949192;
    float sum = heightAt(texel, 0, size), weight = 1.0;
    for (int k = 1; k <= 8; ++k) {
        weight *= z;
        sum += weight * (heightAt(texel, -k, size) + heightAt(texel, k, size));
    }
    imageStore(coefficients, texel, vec4(1.732050808 * sum));
}
