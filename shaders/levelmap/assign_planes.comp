// Gives each texel of a position map (RG32F, in place) the nearest plane of the sub-box that its depth lies in.
// In: sub-boxes from the top down (levelmap/ReferencePlanes.h).
#include "interface/bindings.glsl"
#include "interface/sub_box.glsl"
#include "levelmap/box.glsl"
#include "optics/planes.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(rg32f, binding = positionMapImage) uniform image2D positionMap;
layout(std430, binding = subBoxesBuffer) readonly buffer SubBoxes { SubBox boxes[]; };
layout(location = boxCountLocation) uniform int boxCount;

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(texel, boxSize.xy))) return;
    vec2 position = imageLoad(positionMap, texel).xy;
    if (position.y < 0.0) return;
    int at = 0;
    while (at + 1 < boxCount && boxes[at + 1].top <= position.x) ++at;
    int plane = boxes[at].firstPlane + planeIndex(position.x - boxes[at].top, boxes[at].height, boxes[at].planeCount);
    imageStore(positionMap, texel, vec4(position.x, float(plane), 0.0, 0.0));
}
