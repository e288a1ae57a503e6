// A ray from the surface, followed through a view of the receivers until it meets what the view holds. Flat water
// meets it at the first look; waves turn the ray aside, and the view says what is there.
// A view: RGBA32F radiance, alpha the share of receivers in the texel; R32F metres from where it is seen (seenFrom),
// below 0 where nothing is.
#include "view/view.glsl"

const float nothing = 1e29;
const int mostLooks = 48, halvings = 6;

struct Met {
    vec4 radiance; // alpha: how much of a receiver the ray meets
    float metres;  // from the surface to it
};

vec2 viewUv(vec3 point, int way) {
    vec4 clip = viewClip(point, way);
    return 0.5 + 0.5 * clip.xy / clip.w;
}

// Metres of a ray within a box, from where to where; empty if the first is greater.
vec2 withinBox(vec3 from, vec3 direction, vec3 low, vec3 high) {
    vec3 inverse = 1.0 / (direction + vec3(equal(direction, vec3(0.0))) * 1e-20);
    vec3 a = (low - from) * inverse, b = (high - from) * inverse;
    vec3 enter = min(a, b), leave = max(a, b);
    return vec2(max(max(enter.x, enter.y), max(enter.z, 0.0)), min(leave.x, min(leave.y, leave.z)));
}

// How far the point lies behind what the view shows in its place, m; -nothing where it shows nothing.
float behind(sampler2D distances, vec3 point, int way) {
    vec2 uv = viewUv(point, way);
    if (any(lessThan(uv, vec2(0.0))) || any(greaterThan(uv, vec2(1.0)))) return -nothing;
    float first = texelFetch(distances, ivec2(uv * vec2(textureSize(distances, 0))), 0).x;
    return first < 0.0 ? -nothing : distance(point, seenFrom(point, way)) - first;
}

Met metAt(sampler2D radiances, vec3 from, vec3 direction, float metres, int way) {
    vec4 radiance = texture(radiances, viewUv(from + metres * direction, way));
    return Met(vec4(radiance.rgb / max(radiance.a, 1e-3), radiance.a), metres);
}

// `low` and `high` bound all receivers of the view; `from` lies on the water, `direction` is unit.
Met followView(sampler2D radiances, sampler2D distances, int way, vec3 from, vec3 direction, vec3 low, vec3 high) {
    vec2 within = withinBox(from, direction, low, high);
    if (within.x >= within.y) return Met(vec4(0.0), 0.0);
    // Looks are evenly spaced in the view, two texels apart or more: a stretch t of the ray seen from `away` moves by
    // t / (t + away) of all it will ever move.
    float away = max(distance(from, cameraPosition.xyz), 1e-6);
    vec2 span = within / (within + away);
    vec2 moved = (viewUv(from + within.y * direction, way) - viewUv(from + within.x * direction, way)) * vec2(textureSize(distances, 0));
    int looks = int(clamp(ceil(0.5 * length(moved)), way == mirrored ? 1.0 : 4.0, float(mostLooks)));
    float before = within.x;
    float atBefore = behind(distances, from + before * direction, way);
    // Where it ends behind something, the view cannot say what it met: what was last in the open is next to that.
    float open = -1.0, beyond = 0.0;
    bool hidden = false;
    for (int i = 0; i <= looks; ++i) {
        float share = mix(span.x, span.y, float(i) / float(looks));
        float here = min(away * share / (1.0 - share), within.y);
        float atHere = i == 0 ? atBefore : behind(distances, from + here * direction, way);
        // Behind it, but not by more than it has gone since the last look: it went in, and did not pass behind.
        if (atHere >= 0.0 && atHere <= 1.01 * (here - before) + 5e-3 * (here + away)) {
            for (int k = 0; k < halvings && i > 0; ++k) {
                float middle = 0.5 * (before + here);
                if (behind(distances, from + middle * direction, way) >= 0.0) here = middle;
                else before = middle;
            }
            return metAt(radiances, from, direction, here, way);
        }
        if (atHere < 0.0) open = atHere > -nothing ? here : -1.0, beyond = -atHere;
        hidden = atHere >= 0.0;
        before = here;
    }
    if (!hidden || open < 0.0) return Met(vec4(0.0), 0.0);
    Met met = metAt(radiances, from, direction, open, way);
    met.metres += beyond;
    return met;
}
