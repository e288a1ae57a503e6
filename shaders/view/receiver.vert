// A receiver's corner on its way to the tessellator: seen through water, straight edges are curves.
#include "include/receiver_vertex.glsl"
void main() { passVertex(); }
