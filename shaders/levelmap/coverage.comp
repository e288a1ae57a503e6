// How much of each texel of a level map the surface at its middle covers.
// In: R8, places that show that surface (coverage.frag); position map. Out, R32F: their share of the texel's places, at least
// half a place; 0 where there is no receiver.
#include "interface/bindings.glsl"
#include "levelmap/box.glsl"
#include "levelmap/coverage_places.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = coveredUnit) uniform sampler2D covered;
layout(binding = positionMapUnit) uniform sampler2D positionMap; // RG32F (level_map.frag)
layout(r32f, binding = coverageImage) uniform writeonly image2D coverage;
layout(location = placesLocation) uniform float places; // along a texel's side

float shareOf(ivec2 texel) {
    vec2 at = leant(vec2(texel));
    ivec2 low = ivec2(floor(places * (at - vec2(0.0, coverageLean)))), high = ivec2(ceil(places * (at + vec2(1.0 + coverageLean, 1.0))));
    float all = 0.0, shown = 0.0;
    for (int y = low.y; y < high.y; ++y)
        for (int x = low.x; x < high.x; ++x) {
            if (ivec2(floor(upright((vec2(x, y) + 0.5) / places))) != texel) continue;
            all += 1.0;
            shown += texelFetch(covered, ivec2(x, y), 0).r;
        }
    return all > 0.0 ? max(shown, 0.5) / all : 1.0;
}

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(texel, boxSize.xy))) return;
    bool seen = texelFetch(positionMap, texel, 0).y != -1.0;
    imageStore(coverage, texel, vec4(seen ? shareOf(texel) : 0.0));
}
