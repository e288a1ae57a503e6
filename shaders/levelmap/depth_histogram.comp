// Counts the texels of each depth level or reference plane (thesis 4.7.2, depth profiling).
// In: position map, RG32F (level_map.frag). Out: one count a bin. Texels that take no light do not count.
#include "interface/bindings.glsl"
#include "levelmap/box.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = positionMapUnit) uniform sampler2D positionMap;
layout(std430, binding = histogramBuffer) buffer Histogram { uint counts[]; };
layout(location = depthLevelsLocation) uniform int depthLevels; // bins over the box's height; 0: a bin for each reference plane

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(texel, boxSize.xy))) return;
    vec2 position = texelFetch(positionMap, texel, 0).xy;
    if (position.y < 0.0) return;
    int bin = int(position.y);
    if (depthLevels > 0) bin = clamp(int(position.x / boxExtent.z * float(depthLevels)), 0, depthLevels - 1);
    atomicAdd(counts[bin], 1u);
}
