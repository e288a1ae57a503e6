// The sub-volumes that sample planes cut illumination volumes into (Iwasaki et al. 2002, 4.3.1). There is one to each
// reference plane of a receiver's box, and the sample planes lie half-way between those: what a sub-volume may hold are
// the texels whose index is its number.
#include "interface/bindings.glsl"
#include "caustics/footprint.glsl"
#include "levelmap/depth_pyramid.glsl"
#include "optics/planes.glsl"
layout(binding = depthPyramidUnit) uniform sampler2D depthPyramid; // RGBA32F (levelmap/PlaneDepths.h)

// Depths of the sample planes above and below sub-volume `number`, m. The outermost lie a little outside of the box.
vec2 subVolume(int number) {
    float gap = planeGap(boxExtent.z, boxSize.z), middle = planeDepth(boxExtent.z, boxSize.z, number);
    float outside = 0.02 * boxExtent.z;
    return vec2(number == 0 ? -outside : middle - 0.5 * gap, number == boxSize.z - 1 ? boxExtent.z + outside : middle + 0.5 * gap);
}

// First and last sub-volume of what the planes of texels lie between; first > last for none.
ivec2 subVolumesOf(vec2 planes) {
    if (planes.x > planes.y) return ivec2(1, 0);
    return ivec2(planeIndex(planes.x, boxExtent.z, boxSize.z), planeIndex(planes.y, boxExtent.z, boxSize.z));
}

// Those of the texels within the bounding box of a beam between two depths.
ivec2 subVolumesWithin(vec4 a, vec4 b, vec4 c, vec2 depths) {
    vec2 least = vec2(1e30), most = vec2(-1e30);
    for (int i = 0; i < 2; ++i) {
        vec2 p = a.xy + depths[i] * a.zw, q = b.xy + depths[i] * b.zw, r = c.xy + depths[i] * c.zw;
        least = min(least, min(min(p, q), r)), most = max(most, max(max(p, q), r));
    }
    const float margin = 1.0 / 64.0; // corners snap by less
    ivec2 low = ivec2(clamp(ceil(least - 0.5 - margin), vec2(0.0), vec2(boxSize.xy)));
    ivec2 high = ivec2(clamp(floor(most - 0.5 + margin), vec2(-1.0), vec2(boxSize.xy - 1)));
    if (any(greaterThan(low, high))) return ivec2(1, 0);
    return subVolumesOf(depthRange(depthPyramid, low, high));
}

// What a depth in m is to rasterisers: clear of the clip planes.
float clipDepth(float depth) { return 1.8 * (depth / boxExtent.z - 0.5); }
