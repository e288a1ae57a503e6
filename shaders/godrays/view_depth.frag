// How far what is no hole lies: 1 over metres along the view, in alpha.
#include "levelmap/receiver_fragment.glsl"
out vec4 outFar;

void main() {
    if (isHole()) discard;
    outFar = vec4(0.0, 0.0, 0.0, gl_FragCoord.w);
}
