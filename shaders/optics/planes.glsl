// Reference planes of a box: `count` planes over `height` metres, both faces included; depth runs along the
// light, 0 at the near face. Decided by index, not by |z - D| <= gap/2: a texel half-way between two planes
// would otherwise be taken twice (thesis eq. 4-15).

// Metres between neighbours; the whole height for one plane.
float planeGap(float height, int count) { return count > 1 ? height / float(count - 1) : height; }

// Depth of plane `index`; one plane lies in the middle.
float planeDepth(float height, int count, int index) {
    return count > 1 ? float(index) * planeGap(height, count) : 0.5f * height;
}

// The plane that a surface at `depth` belongs to, [0, count - 1].
int planeIndex(float depth, float height, int count) {
    if (count <= 1) return 0;
    return clamp(int(floor(depth / planeGap(height, count) + 0.5f)), 0, count - 1);
}
