#include "optics/cross.glsl"

// Cross-section of a beam at depth z: twice its signed area is c0 + c1 z + c2 z². A ray is where it crosses depth 0 and by
// how much it goes aside with depth, in any unit.
vec3 crossSection(vec4 a, vec4 b, vec4 c) {
    vec4 e = b - a, f = c - a;
    return vec3(cross2(e.xy, f.xy), cross2(e.xy, f.zw) + cross2(e.zw, f.xy), cross2(e.zw, f.zw));
}

// Depths at which the cross-section of a beam is no area, in rising order; 1e30 for none.
vec2 turnsOf(vec3 section) {
    float scale = abs(section.y) + sqrt(abs(section.x * section.z));
    if (abs(section.z) <= 1e-7f * scale) return vec2(section.y != 0.0f ? -section.x / section.y : 1e30f, 1e30f);
    float square = section.y * section.y - 4.0f * section.x * section.z;
    if (square <= 0.0f) return vec2(1e30f);
    float half_ = -0.5f * (section.y + (section.y < 0.0f ? -1.0f : 1.0f) * sqrt(square));
    vec2 turns = vec2(half_ / section.z, section.x / half_);
    return vec2(min(turns.x, turns.y), max(turns.x, turns.y));
}
