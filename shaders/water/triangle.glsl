// Rays that a beam is counted by, of equal flux.
const int raysPerBeam = 16;

// Evenly spread points of a triangle, as barycentric coordinates: the R2 sequence (Roberts 2018), folded at the
// diagonal of the unit square.
vec3 trianglePoint(int i) {
    vec2 r = fract(0.5 + float(i) * vec2(0.7548776662466927, 0.5698402909980532));
    if (r.x + r.y > 1.0) r = 1.0 - r;
    return vec3(1.0 - r.x - r.y, r);
}
