// Whether a level map's receiver is at a place of the map.
// Out, R8: 1 (cleared to 0: no receiver).
#include "include/level_map_texel.glsl"
layout(location = 0) out float outCovered;

void main() {
    if (!isInMap()) discard;
    outCovered = 1.0;
}
