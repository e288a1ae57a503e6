// The water's surface as the picture draws it: a grid of triangles in flat water.

// Outside of the grid the water is flat; in the picture, waves die away over its rim, so that the two meet without a
// step. The share of the waves' height that is left at `inside`, the place in the grid's rectangle, [0, 1]².
float rimShare(vec2 inside) {
    vec2 rim = smoothstep(vec2(0.0f), vec2(0.06f), min(inside, vec2(1.0f) - inside));
    return rim.x * rim.y;
}

// Height in a quad at `f` in [0, 1]² of what its corners have: a at (0, 0), b at (1, 0), c at (0, 1), d at (1, 1).
// Quads whose numbers in x and z have an even sum are cut from b to c, the others from a to d
// (water/WaterSurface.cpp).
float quadHeight(bool even, vec2 f, float a, float b, float c, float d) {
    if (even) {
        if (f.x + f.y < 1.0f) return a + f.x * (b - a) + f.y * (c - a);
        return d + (1.0f - f.x) * (c - d) + (1.0f - f.y) * (b - d);
    }
    if (f.x < f.y) return a + f.y * (c - a) + f.x * (d - c);
    return a + f.x * (b - a) + f.y * (d - b);
}
