// Adds what arrives at a texel to its sums: one channel, or three with COLOURED.
#include "interface/flux_sums.glsl"

void deposit(ivec2 texel, vec3 amount) {
    int index = texel.y * boxSize.x + texel.x;
#ifdef COLOURED
    for (int channel = 0; channel < 3; ++channel)
        if (amount[channel] > 0.0) addFlux(3 * index + channel, amount[channel]);
#else
    if (amount.r > 0.0) addFlux(index, amount.r);
#endif
}
