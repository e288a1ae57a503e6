// A receiver's corner on its way to the tessellator: seen through water, straight edges are curves.
#include "levelmap/receiver_vertex.glsl"
void main() { passVertex(); }
