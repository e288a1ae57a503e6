// Least and greatest depth over a rectangle of texels, from a pyramid (levelmap/depth_pyramid.comp): a little more than
// the rectangle is asked, never less. x > y where nothing is there.
vec2 depthRange(sampler2D pyramid, ivec2 low, ivec2 high) {
    ivec2 span = high - low;
    // The level at which the rectangle touches at most two nodes each way.
    int level = findMSB(max(span.x, span.y)) + 1;
    // Not textureSize(pyramid, level): Mesa's software driver answers it with one invocation's level for all.
    ivec2 last = max(textureSize(pyramid, 0) >> level, 1) - 1;
    ivec2 a = min(low >> level, last), b = min(high >> level, last);
    vec2 p = texelFetch(pyramid, a, level).xy, q = texelFetch(pyramid, b, level).xy;
    vec2 r = texelFetch(pyramid, ivec2(a.x, b.y), level).xy, s = texelFetch(pyramid, ivec2(b.x, a.y), level).xy;
    return vec2(min(min(p.x, q.x), min(r.x, s.x)), max(max(p.y, q.y), max(r.y, s.y)));
}
