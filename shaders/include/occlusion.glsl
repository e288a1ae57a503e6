// Whether something takes a beam on its way, in the beam's own direction. Two solids are known along the mean light from
// each place of the flat surface (scene_depth.glsl): where each is entered and where it is left; a sheet is left where it
// is entered. A beam is taken where it is between the two. A third solid below takes nothing.
//
// Places are compared on the flat surface, where the mean light to them enters: of a beam that starts `aside` from the
// place of the point X that it goes to, the part at depth (1 - f) D of X's depth D is f · aside away from it.
#include "include/box.glsl"
#include "include/scene_depth.glsl"
layout(binding = 6) uniform sampler2D scenePyramid; // RGBA32F (scene_depth_range.comp)
layout(binding = 8) uniform sampler2D secondSolids; // RG32F (the same)

// How much the depth of a face changes from one texel of the scene depth map to the next because a lamp's rays fan out, m:
// under flat water a ray that enters `away` from the lamp's foot leans by tan = away / q, q² = n² above² + (n² - 1) away²,
// and comes `away` + tan · below aside. From texels that far apart on the receiver, depth grows by lean and slope.
float fanned(vec3 entry, float depth, float slope) {
    if (!isPointLight()) return 0.0;
    float above = lightPosition.y - waterSurface.x, away = distance(entry.xz, lightPosition.xz), n2 = waterSurface.y * waterSurface.y;
    float q = sqrt(n2 * above * above + (n2 - 1.0) * away * away);
    return sceneDepthTexel() * (depth / q) * (away / q + slope);
}

// Depths within this much of a point are the surface that it lies on itself, m: `slope` is how depth grows sideways. All of
// the texels that asideOfNearest looks at are within two.
float contact(vec3 entry, float depth, float slope) {
    float lean = min(slope, 10.0);
    return sceneDepthTexel() * (3.0 + 2.0 * lean) + 2.0 * fanned(entry, depth, lean);
}

// The same for another receiver's surface, m.
float besideOthers() { return 0.5 * sceneDepthTexel(); }

// Where to ask for a point of a face with this normal, from the point, m: a face of a further map runs along the light and
// is its own edge in the scene depth map, so it is asked for beside it. BoxFrame is that of the point's map.
vec3 besideFace(vec3 normal) { return (boxSize.w & 7) != 0 ? normal * (2.0 * sceneDepthTexel()) : vec3(0.0); }

// Least entered, greatest entered, least left over a square of places.
vec3 sceneRange(ivec2 low, ivec2 high) {
    ivec2 size = textureSize(scenePyramid, 0);
    if (any(lessThan(high, ivec2(0))) || any(greaterThanEqual(low, size))) return vec3(1e30);
    ivec2 a = clamp(low, ivec2(0), size - 1), b = clamp(high, ivec2(0), size - 1), span = b - a;
    int level = min(findMSB(max(span.x, span.y)) + 1, textureQueryLevels(scenePyramid) - 1);
    ivec2 last = max(size >> level, 1) - 1; // as depth_pyramid.glsl has it
    a = min(a >> level, last), b = min(b >> level, last);
    vec3 p = texelFetch(scenePyramid, a, level).xyz, q = texelFetch(scenePyramid, b, level).xyz;
    vec3 r = texelFetch(scenePyramid, ivec2(a.x, b.y), level).xyz, s = texelFetch(scenePyramid, ivec2(b.x, a.y), level).xyz;
    // Beyond the map nothing lies: its greatest depth is none.
    bool inside = all(greaterThanEqual(low, ivec2(0))) && all(lessThan(high, size));
    return vec3(min(min(p.x, q.x), min(r.x, s.x)), inside ? max(max(p.y, q.y), max(r.y, s.y)) : 1e30,
                min(min(p.z, q.z), min(r.z, s.z)));
}

// How far aside the nearest places let a beam start, m: each texel by itself; what lies before `beforeItself` of the point's
// own surface counts, and what before `beforeOthers` of other receivers: where one touches this one, its own surface is
// no excuse. Negative where the point is in the shade of what is right before it.
float asideOfNearest(ivec2 at, float depth, float beforeItself, float beforeOthers, float width, int receiverNumber) {
    ivec2 last = textureSize(scenePyramid, 0) - 1;
    float certain = 1e30;
    for (int y = -2; y <= 2; ++y)
        for (int x = -2; x <= 2; ++x) {
            ivec2 place = at + ivec2(x, y);
            if (any(lessThan(place, ivec2(0))) || any(greaterThan(place, last))) continue;
            vec4 solid = texelFetch(scenePyramid, place, 0);
            float entered = solid.x;
            int offset = max(abs(x), abs(y));
            if (entered >= (int(solid.w) == receiverNumber ? beforeItself : beforeOthers)) continue;
            if (offset <= 1) return -1.0;
            certain = min(certain, (float(offset) - 0.5) * width * depth / (depth - entered));
        }
    return certain;
}

// How far aside a beam to `point` may start and its fate still be certain, m: positive, and it arrives; negative, and it
// does not; 0, and only following it can tell. `slope` as for contact().
float certainAside(vec3 point, float slope, int receiverNumber) {
    vec3 entry = entryPoint(point);
    float depth = distance(point, entry), first = depth - contact(entry, depth, slope);
    vec2 size = vec2(textureSize(sceneDepth, 0));
    vec2 texel = sceneDepthRect.zw / size;
    float width = min(texel.x, texel.y);
    ivec2 at = ivec2(floor(sceneDepthUv(entry) * size));
    int furthest = int(2.0 * max(size.x, size.y));
    float certain = asideOfNearest(at, depth, first, depth - besideOthers(), width, receiverNumber);
    if (certain < 0.0) {
        // In the shade, as far as all that is around is inside of something at one depth.
        float dark = 0.0;
        for (int reach = 2; reach < furthest; reach *= 2) {
            vec3 range = sceneRange(at - reach, at + reach);
            if (range.y >= min(range.z, first)) break;
            dark = (float(reach) - 1.5) * width;
        }
        return -dark;
    }
    for (int reach = 4; reach < furthest; reach *= 2) {
        // What is nearer than half the reach was seen before.
        float near = (float(reach / 2) - 0.5) * width;
        if (certain <= near) break;
        vec3 range = sceneRange(at - reach, at + reach);
        if (range.x < first) certain = min(certain, near * depth / (depth - range.x));
    }
    return certain;
}

// Follows a beam from `start` at the surface to `point` of a receiver, a texel of the map at a time. (Asking the pyramid
// for eight at once cost more than it saved: software GL runs both ways of every branch.)
bool isTaken(vec3 start, vec3 point, float slope, int receiverNumber) {
    vec3 entry = entryPoint(point);
    float depth = distance(point, entry);
    float beforeItself = depth - contact(entry, depth, slope), beforeOthers = depth - besideOthers();
    vec2 size = vec2(textureSize(sceneDepth, 0));
    vec2 from = sceneDepthUv(entryPoint(start)) * size, to = sceneDepthUv(entry) * size;
    int steps = clamp(int(ceil(max(abs(to.x - from.x), abs(to.y - from.y)))), 1, 128);
    for (int i = 0; i < steps; ++i) {
        // The stretch of the beam over one place: entered and left depth of the beam there.
        float f = (float(i) + 0.5) / float(steps);
        float before = depth * float(i) / float(steps), after = depth * float(i + 1) / float(steps);
        ivec2 place = ivec2(floor(mix(from, to, f)));
        if (all(greaterThanEqual(place, ivec2(0))) && all(lessThan(place, ivec2(size)))) {
            vec4 solid = texelFetch(scenePyramid, place, 0);
            bool itself = int(solid.w) == receiverNumber;
            float reached = min(after, itself ? beforeItself : beforeOthers);
            if (reached > solid.x && before <= solid.z) return true;
            vec2 second = texelFetch(secondSolids, place, 0).xy;
            if (min(after, beforeItself) > second.x && before <= second.y) return true;
        }
    }
    return false;
}

// The same for a point of a texel whose certainAside is known: followed only where that does not tell.
bool isShaded(vec3 start, vec3 point, float certain, float slope, int receiverNumber) {
    float aside = distance(entryPoint(start).xz, entryPoint(point).xz);
    return aside >= certain && (aside < -certain || isTaken(start, point, slope, receiverNumber));
}
