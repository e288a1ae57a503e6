#ifndef CROSS // more than one of the files that C++ includes has it
#define CROSS
// Twice the signed area of the triangle that two vectors span.
float cross2(vec2 a, vec2 b) { return a.x * b.y - a.y * b.x; }
#endif
