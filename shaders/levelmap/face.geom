// A receiver's triangles with their own planes.
#include "levelmap/face.glsl"

void main() { passFace(); }
