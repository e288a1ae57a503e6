// Out, R32F, the largest counts: metres along the light from here to the flat surface.
#include "water/surface_shadow.glsl"
#include "levelmap/receiver_fragment.glsl"
out float outDistance;

void main() {
    vec3 position = fragmentIn.position;
    bool hole = isHole();
    if (hole || position.y < waterSurface.x) discard;
    outDistance = distance(position, straightFoot(position));
}
