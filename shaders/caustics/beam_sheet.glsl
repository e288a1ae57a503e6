// A quad's two beams cut by one plane, and what each texel takes of them. Lengths in texels; places from the corner p.
#include "optics/beam_area.glsl"

struct Sheet {
    vec2 origin; // p in the map
    vec2 q, r, s;
    BeamEdge rp, pq, qr, ps, sq;
    vec2 least, most; // bounds
    vec2 areas;       // twice those of r p q and q p s
    vec2 flux;        // of both
};

// Light in focus: a beam thinner than 1/256 texel is widened to that, so that its share stays a ratio of numbers that
// float tells apart. It moves light by no more than that and loses none.
void widen(inout vec2 q, inout vec2 r, inout vec2 s) {
    float width = length(q);
    vec2 unit = width > 1e-12 ? q / width : vec2(1.0, 0.0);
    if (width < thinnest) q = thinnest * unit;
    vec2 aside = vec2(-unit.y, unit.x);
    float acrossR = dot(aside, r), acrossS = dot(aside, s);
    if (abs(acrossR) < thinnest) r += aside * ((acrossR < 0.0 ? -thinnest : thinnest) - acrossR);
    if (abs(acrossS) < thinnest) s += aside * ((acrossS < 0.0 ? -thinnest : thinnest) - acrossS);
}

Sheet sheetOf(vec2 p, vec2 q, vec2 r, vec2 s, vec2 flux) {
    q -= p, r -= p, s -= p;
    vec2 areas = abs(vec2(cross2(q, r), cross2(q, s)));
    float least = min(areas.x, areas.y);
    if (least * least < thinnest * thinnest * max(dot(q, q), thinnest * thinnest)) {
        widen(q, r, s);
        areas = abs(vec2(cross2(q, r), cross2(q, s)));
    }
    vec2 zero = vec2(0.0);
    return Sheet(p, q, r, s, beamEdge(r, zero), beamEdge(zero, q), beamEdge(q, r), beamEdge(zero, s), beamEdge(s, q),
                 min(min(zero, q), min(r, s)), max(max(zero, q), max(r, s)), areas, flux);
}

// The rectangle of a texel, cut down to the sheet's bounds.
void texelIn(Sheet sheet, vec2 texel, out vec2 low, out vec2 high) {
    low = clamp(texel - sheet.origin, sheet.least, sheet.most);
    high = clamp(texel + 1.0 - sheet.origin, sheet.least, sheet.most);
}

// Flux of both beams that falls into a rectangle.
float fluxIn(Sheet sheet, vec2 low, vec2 high) {
    // Beside the sheet there is only rounding, and light along a face is dense enough to make it count.
    if (any(lessThanEqual(high, low))) return 0.0;
    float diagonal = edgeInRectangle(sheet.pq, low, high);
    float upper = edgeInRectangle(sheet.rp, low, high) + diagonal + edgeInRectangle(sheet.qr, low, high);
    float lower = edgeInRectangle(sheet.ps, low, high) + edgeInRectangle(sheet.sq, low, high) - diagonal;
    vec2 shares = min(2.0 * abs(vec2(upper, lower)) / sheet.areas, vec2(1.0));
    return dot(sheet.flux, shares);
}

// About the middle of the part of the beams that a rectangle holds.
vec2 middleIn(Sheet sheet, vec2 low, vec2 high) {
    return 0.25 * (clamp(vec2(0.0), low, high) + clamp(sheet.q, low, high) + clamp(sheet.r, low, high) + clamp(sheet.s, low, high));
}

// Weights of the corners p, q, r, s at a place.
vec4 weightsAt(Sheet sheet, vec2 place) {
    bool upper = cross2(sheet.q, place) * cross2(sheet.q, sheet.r) > 0.0;
    vec2 third = upper ? sheet.r : sheet.s;
    float area = cross2(sheet.q, third);
    if (abs(area) < thinnest * thinnest) return vec4(0.25);
    float t = clamp(cross2(sheet.q, place) / area, 0.0, 1.0), q = clamp(cross2(place, third) / area, 0.0, 1.0 - t);
    return vec4(1.0 - t - q, q, upper ? t : 0.0, upper ? 0.0 : t);
}
