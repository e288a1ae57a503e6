// Outside of the grid the water is flat; in the picture, waves die away over its rim, so that the two meet without a
// step. The share of the waves' height that is left at `inside`, the place in the grid's rectangle, [0, 1]².
float rimShare(vec2 inside) {
    vec2 rim = smoothstep(vec2(0.0f), vec2(0.06f), min(inside, vec2(1.0f) - inside));
    return rim.x * rim.y;
}
