// Where a ray below the surface meets something, in its own direction, by what the mean light meets first.
#include "levelmap/scene_depth.glsl"

const int leaps = 48, halvings = 10;

// Leaps of most of the way to what the mean light would meet from here, until that is passed. A ray that slips behind an
// edge ends there: what it meets behind is not in the map. `farthest`: m of water below which nothing lies; `reach`: for a
// ray that meets nothing.
float metresToHit(vec3 from, vec3 direction, float farthest, float reach) {
    float low = 0.0;
    vec2 gap = beforeFirst(from);
    for (int i = 0; i < leaps && low < 1.5 * farthest; ++i) {
        float high = low + (gap.y > 1e29 ? farthest / 16.0 : max(0.7 * gap.x, farthest / 200.0));
        vec2 next = beforeFirst(from + high * direction);
        if (next.x > 0.0) {
            low = high;
            gap = next;
            continue;
        }
        for (int k = 0; k < halvings; ++k) {
            float middle = 0.5 * (low + high);
            if (beforeFirst(from + middle * direction).x > 0.0) low = middle;
            else high = middle;
        }
        return high;
    }
    return reach;
}
