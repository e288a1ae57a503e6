// Out, R32F, the smallest counts: metres from the point light.
#include "water/light.glsl"
#include "levelmap/receiver_fragment.glsl"
out float outDistance;

void main() {
    if (fragmentIn.position.y > waterSurface.x || isHole()) discard;
    outDistance = distance(fragmentIn.position, lightPosition.xyz);
}
