// From integer sums to a texture that is filtered, and zero again for the next time.
// Out: R32F, a layer for each gap, in the unit of shaft_deposit.comp.
#include "interface/bindings.glsl"
#include "interface/flux_sums.glsl"
layout(local_size_x = 64) in;
layout(binding = litImage, r32f) uniform writeonly image2DArray lit;
layout(location = cellsAcrossLocation) uniform ivec2 cellsAcross;
layout(location = gapCountLocation) uniform int gapCount;
layout(location = stepsLocation) uniform float steps; // of the sums

void main() {
    int index = int(gl_GlobalInvocationID.y * gl_NumWorkGroups.x * gl_WorkGroupSize.x + gl_GlobalInvocationID.x);
    int layer = cellsAcross.x * cellsAcross.y;
    if (index >= layer * gapCount) return;
    int within = index % layer;
    imageStore(lit, ivec3(within % cellsAcross.x, within / cellsAcross.x, index / layer), vec4(takeSum(index) / steps));
}
