// How much of a texel a beam covers, in texels.
#include "optics/cross.glsl"

// An edge of a polygon, made ready to be asked about many rectangles. Its axes are turned so that `t` is the one along
// which it runs further: no quotient is then large that is not multiplied by as small a number.
struct BeamEdge {
    vec2 from, to; // (s, t)
    float run;     // of s by t, at most 1
    float rise;    // of t by s; 0 where s does not change
    float turned;  // 1 where s is y
};

BeamEdge beamEdge(vec2 u, vec2 v) {
    BeamEdge edge;
    vec2 way = v - u;
    bool turned = abs(way.x) > abs(way.y);
    edge.from = turned ? vec2(u.y, u.x) : u;
    edge.to = turned ? vec2(v.y, v.x) : v;
    float s = turned ? way.y : way.x, t = turned ? way.x : way.y;
    edge.run = t != 0.0f ? s / t : 0.0f;
    edge.rise = abs(s) > 1e-9f * abs(t) ? t / s : 0.0f;
    edge.turned = turned ? 1.0f : 0.0f;
    return edge;
}

// The part of a closed polygon inside a rectangle is the sum of this over its edges: the integral of y dx along the
// edge, x and y both clamped to the rectangle and counted from its corner `low`; signed by the way the edge runs. Exact,
// and no polygon is ever cut. Where the rectangle is cut down to what bounds the polygon, all numbers are of the size of
// the smaller of the two, and so are the errors of their rounding.
float edgeInRectangle(BeamEdge edge, vec2 low, vec2 high) {
    bool turned = edge.turned > 0.5f;
    vec2 corner = turned ? vec2(low.y, low.x) : low, size = turned ? vec2(high.y - low.y, high.x - low.x) : high - low;
    vec2 from = edge.from - corner, to = edge.to - corner;
    float s0 = clamp(from.x, 0.0f, size.x), s1 = clamp(to.x, 0.0f, size.x);
    // Along t where s is inside; from there on, the integral of clamped t.
    float t0 = from.y + (s0 - from.x) * edge.rise, t1 = to.y + (s1 - to.x) * edge.rise;
    float c0 = clamp(t0, 0.0f, size.y), c1 = clamp(t1, 0.0f, size.y);
    float part = edge.run * (c1 * (t1 - 0.5f * c1) - c0 * (t0 - 0.5f * c0));
    // Of a turned edge that was the integral of x dy.
    float corners = s1 * clamp(to.y, 0.0f, size.y) - s0 * clamp(from.y, 0.0f, size.y);
    return turned ? corners - part : part;
}

// Twice the signed area of a triangle with a corner at the origin.
