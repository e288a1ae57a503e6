// The water below the level, cut by level planes into gaps, thin ones where receivers are and ever thicker ones below:
// over each lies one layer of cells, as wide as the light has spread by there.
#pragma once
struct Gap {
    vec4 rect;  // x, z of the layer's corner and its extents, m from the scene's origin
    vec4 depth; // m below the level: top, middle, bottom
};
