// A ray of a beam seen from a receiver's box: it meets depth z at `at + z · slope`, in texels of the receiver's maps.
#include "levelmap/box.glsl"
#include "water/cross_section.glsl"

// (at, slope) in texels and texels per metre of a ray, both in the box's axes, m.
vec4 rayFootprint(vec3 origin, vec3 direction) {
    // A ray that runs nearly across the box or backwards does not meet its planes in any useful place; the slope
    // marks it, and beams with such an edge carry nothing.
    vec2 slope = direction.z > 0.02 ? direction.xy / direction.z : vec2(1e6);
    // The same bits in every program: a pass over all tiles and one over those kept find the same texels.
    precise vec2 at = origin.xy - slope * origin.z;
    return vec4(at, slope) / boxExtent.w;
}

// Whether all three rays of a beam meet the box's planes.
bool meetsPlanes(vec4 a, vec4 b, vec4 c) { return max(abs(a.z), max(abs(b.z), abs(c.z))) * boxExtent.w < 1e5; }

// Rasterisers place corners on a grid of 1/256 texel and cover a texel's centre with no triangle that is smaller
// than half a cell of it, in texels; so this is no clamp of the light, it only keeps rounding from dividing by 0.
const float smallestTwiceArea = 1.0 / 65536.0;

// Flux of a beam over the area of its cross-section at `depth` m, by texels.
float fluxPerTexel(vec3 section, float flux, float depth) {
    float twiceArea = abs(section.x + depth * (section.y + depth * section.z));
    return 2.0 * flux / max(twiceArea, smallestTwiceArea);
}
