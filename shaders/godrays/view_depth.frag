// Depth of what is no hole.
#include "include/receiver_fragment.glsl"

void main() {
    if (isHole()) discard;
}
