// A receiver's triangles with their own planes.
#include "include/face.glsl"

void main() { passFace(); }
