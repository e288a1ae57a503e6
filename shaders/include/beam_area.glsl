// How much of a texel a beam covers. All in texels, relative to the texel's corner, so that the texel is [0, 1]².

// The part of a closed polygon inside the unit square is the sum of this over its edges: the integral over x in
// [0, 1] of y, clamped to [0, 1], along the edge from `u` to `v`; signed by the way the edge runs in x. Exact, and
// no polygon is ever cut.
float edgeInSquare(vec2 u, vec2 v) {
    float x0 = clamp(u.x, 0.0f, 1.0f), x1 = clamp(v.x, 0.0f, 1.0f);
    float run = v.x - u.x;
    float slope = run != 0.0f ? (v.y - u.y) / run : 0.0f;
    float y0 = u.y + (x0 - u.x) * slope, y1 = u.y + (x1 - u.x) * slope;
    float c0 = clamp(y0, 0.0f, 1.0f), c1 = clamp(y1, 0.0f, 1.0f);
    // Mean of the clamped height: of the stretch inside the square, and of the one above it. In this form nothing
    // cancels, however flat the edge.
    float rise = y1 - y0;
    float inside = 0.5f * (c0 + c1) * (c1 - c0) + (max(y1 - 1.0f, 0.0f) - max(y0 - 1.0f, 0.0f));
    return (x1 - x0) * (rise != 0.0f ? inside / rise : c0);
}

// The same integral with no square: summed over a closed polygon, its signed area.
float edgeArea(vec2 u, vec2 v) { return 0.5f * (u.y + v.y) * (v.x - u.x); }
