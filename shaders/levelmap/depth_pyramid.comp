// One level of a depth pyramid from the finer one. A node holds least and greatest of 2 × 2 nodes; the last of a row or
// column also those of an odd one left over.
// In and out, RG32F: least, greatest depth, m; with EXITS, RGBA32F: the same, least depth of exit, 0.
layout(local_size_x = 8, local_size_y = 8) in;
#ifdef EXITS
layout(rgba32f, binding = 0) uniform readonly image2D finer;
layout(rgba32f, binding = 1) uniform writeonly image2D coarser;
#else
layout(rg32f, binding = 0) uniform readonly image2D finer;
layout(rg32f, binding = 1) uniform writeonly image2D coarser;
#endif

void main() {
    ivec2 node = ivec2(gl_GlobalInvocationID.xy), size = imageSize(coarser), finerSize = imageSize(finer);
    if (any(greaterThanEqual(node, size))) return;
    ivec2 last = ivec2(node.x == size.x - 1 ? finerSize.x - 1 : 2 * node.x + 1,
                       node.y == size.y - 1 ? finerSize.y - 1 : 2 * node.y + 1);
    vec4 range = vec4(1e30, -1e30, 1e30, 0.0);
    for (int y = 2 * node.y; y <= last.y; ++y)
        for (int x = 2 * node.x; x <= last.x; ++x) {
            vec4 part = imageLoad(finer, ivec2(x, y));
            range.xyz = vec3(min(range.x, part.x), max(range.y, part.y), min(range.z, part.z));
        }
    imageStore(coarser, node, range);
}
