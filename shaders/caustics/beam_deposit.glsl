// Adds what arrives at a texel to its sums: one channel, or three with COLOURED.
#include "interface/flux_sums.glsl"

void deposit(ivec2 texel, vec3 amount) {
    int index = texel.y * boxSize.x + texel.x;
#ifdef COLOURED
    addFlux(3 * index, amount.r);
    addFlux(3 * index + 1, amount.g);
    addFlux(3 * index + 2, amount.b);
#else
    if (amount.r > 0.0) addFlux(index, amount.r);
#endif
}
