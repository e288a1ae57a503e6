// Triangles in light's way, their bounding volume hierarchy, and what passes through those that are not opaque. Positions
// in m from the scene's origin.
#pragma once

struct OccluderNode {
    vec3 low;
    int next;  // the node after this one's subtree
    vec3 high;
    int items; // 0: an inner node, its first child comes next; else 8 * first triangle + count
};
struct OccluderTriangle {
    vec3 a;
    int receiver;
    vec3 b;
    int veil; // of the veil triangles; -1: opaque
    vec3 c;
    int spare;
};

struct VeilTriangle {
    vec4 colors[3]; // linear RGB and alpha of the corners
    vec2 uvs[3];
    int material;
    int spare;
};
// Words of a material: alpha below which there is a hole, transmission, 1 where blended, spare; base colour, transmission:
// first texel (-1: no image), width, height, wraps.
const int veilMaterialWords = 12;
const int baseImage = 4, transmissionImage = 8;
