// Unit vectors as two numbers in [0, 1], by projecting the sphere onto an octahedron (Meyer et al. 2010). In
// 16 bits a channel the direction is right to 4e-5 radians.

vec2 octahedralEncode(vec3 n) {
    vec2 p = vec2(n.x, n.y) / (abs(n.x) + abs(n.y) + abs(n.z));
    if (n.z < 0.0f)
        p = vec2((1.0f - abs(p.y)) * (p.x >= 0.0f ? 1.0f : -1.0f), (1.0f - abs(p.x)) * (p.y >= 0.0f ? 1.0f : -1.0f));
    return p * 0.5f + vec2(0.5f);
}

vec3 octahedralDecode(vec2 encoded) {
    vec2 p = encoded * 2.0f - vec2(1.0f);
    vec3 n = vec3(p.x, p.y, 1.0f - abs(p.x) - abs(p.y));
    if (n.z < 0.0f)
        n = vec3((1.0f - abs(p.y)) * (p.x >= 0.0f ? 1.0f : -1.0f), (1.0f - abs(p.x)) * (p.y >= 0.0f ? 1.0f : -1.0f), n.z);
    return normalize(n);
}
