// The pyramid's values over a rectangle of texels (levelmap/depth_pyramid.comp): of a little more than the rectangle,
// never less. x, y: least and greatest depth, x > y where nothing is there; z, w: least values.
vec4 depthNode(sampler2D pyramid, ivec2 low, ivec2 high) {
    ivec2 span = high - low;
    // The level at which the rectangle touches at most two nodes each way; where no power of two is a side of the map,
    // the last level comes before.
    int level = min(findMSB(max(span.x, span.y)) + 1, textureQueryLevels(pyramid) - 1);
    // Not textureSize(pyramid, level): Mesa's software driver answers it with one invocation's level for all.
    ivec2 last = max(textureSize(pyramid, 0) >> level, 1) - 1;
    ivec2 a = min(low >> level, last), b = min(high >> level, last);
    vec4 p = texelFetch(pyramid, a, level), q = texelFetch(pyramid, b, level);
    vec4 r = texelFetch(pyramid, ivec2(a.x, b.y), level), s = texelFetch(pyramid, ivec2(b.x, a.y), level);
    vec4 least = min(min(p, q), min(r, s));
    return vec4(least.x, max(max(p.y, q.y), max(r.y, s.y)), least.zw);
}

vec2 depthRange(sampler2D pyramid, ivec2 low, ivec2 high) { return depthNode(pyramid, low, high).xy; }
