// One level of a depth pyramid from the finer one. A node holds of 2 × 2 nodes the least of x, z and w and the greatest of
// y; the last of a row or column also of those of an odd one left over.
// In and out: RGBA32F.
#include "interface/bindings.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba32f, binding = finerImage) uniform readonly image2D finer;
layout(rgba32f, binding = coarserImage) uniform writeonly image2D coarser;

void main() {
    ivec2 node = ivec2(gl_GlobalInvocationID.xy), size = imageSize(coarser), finerSize = imageSize(finer);
    if (any(greaterThanEqual(node, size))) return;
    ivec2 last = ivec2(node.x == size.x - 1 ? finerSize.x - 1 : 2 * node.x + 1,
                       node.y == size.y - 1 ? finerSize.y - 1 : 2 * node.y + 1);
    vec4 range = vec4(1e30, -1e30, 1e30, 1e30);
    for (int y = 2 * node.y; y <= last.y; ++y)
        for (int x = 2 * node.x; x <= last.x; ++x) {
            vec4 part = imageLoad(finer, ivec2(x, y)), least = min(range, part);
            range = vec4(least.x, max(range.y, part.y), least.zw);
        }
    imageStore(coarser, node, range);
}
