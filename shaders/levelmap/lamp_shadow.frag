// Out, R32F, the smallest counts: metres from the lamp.
#include "include/light.glsl"
#include "include/receiver_fragment.glsl"
layout(location = 0) out float outDistance;

void main() {
    if (fragmentIn.position.y > waterSurface.x || isHole()) discard;
    outDistance = distance(fragmentIn.position, lightPosition.xyz);
}
