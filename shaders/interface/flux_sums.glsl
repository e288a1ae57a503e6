// Sums of flux in integers: the same bits whatever the order. 64 bits a texel and channel as two words, the upper one
// touched only by a carry; in steps so small that rounding is lost in a float.
#include "interface/bindings.glsl"
layout(std430, binding = fluxSumsBuffer) buffer FluxSums { uint sums[]; };

// Adds `amount` steps to sum `index`.
void addFlux(int index, float amount) {
    // A beam that a lens throws on one texel may alone be more than a word.
    float upper = amount >= 4294967040.0 ? floor(amount * (1.0 / 4294967296.0)) : 0.0;
    uint low = uint(max(amount - upper * 4294967296.0 + 0.5, 0.0)); // of what is below 0, uint() may be anything
    uint before = atomicAdd(sums[2 * index], low);
    uint carry = uint(upper) + (before + low < before ? 1u : 0u);
    if (carry > 0u) atomicAdd(sums[2 * index + 1], carry);
}

// What sum `index` holds, in steps; leaves zero for the next map.
float takeSum(int index) {
    float sum = float(sums[2 * index]) + 4294967296.0 * float(sums[2 * index + 1]);
    if (sum > 0.0) sums[2 * index] = 0u, sums[2 * index + 1] = 0u;
    return sum;
}

// The sums of a texel, one channel standing for all three, or three.
vec3 takeSums(int texel, int channels) {
    if (channels == 1) return vec3(takeSum(texel));
    return vec3(takeSum(3 * texel), takeSum(3 * texel + 1), takeSum(3 * texel + 2));
}
