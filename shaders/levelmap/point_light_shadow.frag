// Out, R32F, the smallest counts: metres from the point light.
#include "water/light.glsl"
#include "levelmap/receiver_fragment.glsl"
out float outDistance;

void main() {
    bool hole = isHole();
    if (hole || fragmentIn.position.y > waterSurface.x) discard;
    outDistance = distance(fragmentIn.position, lightPosition.xyz);
}
