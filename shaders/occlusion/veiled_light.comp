// For methods that shade by the mean light: what the sheets before a texel leave of it. What is opaque is the scene depth
// map's business.
// In: position map, tangent by the normal map, occluders. In and out, RGBA16: the share of a texel's light that counts.
#include "interface/bindings.glsl"
#ifndef VEILS
#define VEILS
#endif
#include "water/light.glsl"
#include "occlusion/occluders.glsl"
#include "optics/octahedral.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = positionMapUnit) uniform sampler2D positionMap; // RG32F (levelmap/level_map.frag)
layout(binding = normalMapUnit) uniform sampler2D normalMap;     // RG16
layout(rgba16, binding = shareImage) uniform image2D share;
layout(location = receiverNumberLocation) uniform int receiverNumber;

vec3 passingSheets(vec3 from, vec3 to, Target target) {
    Pencil ray = pencilOf(mat4x3(from, from, from, from), mat4x3(to, to, to, to), vec3(0.0));
    vec3 left = vec3(1.0);
    int node = 0;
    do {
        findTriangles(node, ray, target, mostNodes);
        for (int i = 0; i < foundCount; ++i) {
            OccluderTriangle triangle = occluderTriangles[foundTriangles[i]];
            Facet facet;
            vec3 at;
            if (triangle.veil < 0 || !isSheet(triangle.veil) || !facetOf(triangle, target, facet) || !takes(facet, from, to, at)) continue;
            left *= passingTriangle(triangle, facet, at);
        }
    } while (!sawAll(node));
    return left;
}

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(texel, boxSize.xy))) return;
    vec2 position = texelFetch(positionMap, texel, 0).xy;
    if (position.y < 0.0) return;
    vec3 normal = octahedralDecode(texelFetch(normalMap, texel, 0).xy);
    vec2 rise = vec2(dot(normal, boxU.xyz), dot(normal, boxW.xyz)) / max(-dot(normal, boxT.xyz), 1e-3);
    Target target = targetOf(receiverNumber, rise, vec3(0.0));
    vec3 to = boxPoint(vec3((vec2(texel) + 0.5) * boxExtent.w, position.x));
    vec4 before = imageLoad(share, texel);
    imageStore(share, texel, vec4(before.rgb * passingSheets(entryPoint(to), to, target), before.a));
}
