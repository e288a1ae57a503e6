// Which beams of a quad of the water's grid cover a texel's centre: the rule that rasterisers have, in integers. Corners
// snap to a grid of 1/256 texel, and what lies on an edge that two beams share belongs to one of them.

// Corners on one plane, from the texel's centre, in 1/256 texel: p and q the ends of the quad's diagonal, r and s
// beside it. Beams are r p q and q p s.
struct Corners {
    ivec2 p, q, r, s;
};

// Beyond 4 million texels corners stay where they are cut off; a texel sees the same of them in every beam.
ivec2 snapped(vec2 fromCentre) { return ivec2(floor(clamp(fromCentre, -4e6, 4e6) * 256.0 + 0.5)); }

// What lies on an edge belongs to the beam that the edge runs around to the left of it; to the other one if it runs
// the other way.
bool ownsEdge(ivec2 along) { return along.y > 0 || (along.y == 0 && along.x < 0); }

// Whether the centre is left of the edge from u to v, or on it and owned. Corners are less than 64 texels away.
bool isLeft(ivec2 u, ivec2 v) { return u.x * v.y - u.y * v.x >= (ownsEdge(v - u) ? 0 : 1); }

// The same for corners that are any distance away: products take 64 bits.
bool isLeftFar(ivec2 u, ivec2 v) {
    int highA, lowA, highB, lowB;
    imulExtended(u.x, v.y, highA, lowA);
    imulExtended(u.y, v.x, highB, lowB);
    if (highA != highB) return highA > highB;
    return lowA == lowB ? ownsEdge(v - u) : uint(lowA) > uint(lowB);
}

// Sides of the edges rp, pq, qr; ps, sq.
bvec2 coveringBeams(bool distinct, bool rp, bool pq, bool qr, bool ps, bool sq) {
    // Right of q p is what is not left of p q. A beam is all left or, wound the other way, all right.
    return bvec2(distinct && rp == pq && qr == pq, distinct && ps == !pq && sq == !pq);
}

// Which of r p q, q p s cover the centre. `far`: some corner may be 64 texels away.
bvec2 covering(Corners c, bool far) {
    bool distinct = any(notEqual(c.p, c.q));
    if (far)
        return coveringBeams(distinct, isLeftFar(c.r, c.p), isLeftFar(c.p, c.q), isLeftFar(c.q, c.r), isLeftFar(c.p, c.s), isLeftFar(c.s, c.q));
    return coveringBeams(distinct, isLeft(c.r, c.p), isLeft(c.p, c.q), isLeft(c.q, c.r), isLeft(c.p, c.s), isLeft(c.s, c.q));
}
