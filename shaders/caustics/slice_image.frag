// The part of a receiver that is nearest to one plane (thesis 5.2.1, figure 5-2): the sides of the slab are half-way to
// the neighbours, decided by index as in the level map.
// Out 0 to 2: as in level_map.frag.
#include "interface/bindings.glsl"
#include "levelmap/level_map_texel.glsl"
#include "optics/octahedral.glsl"
layout(location = planeNumberLocation) uniform int planeNumber;
layout(location = positionTarget) out vec2 outPosition;
layout(location = diffuseTarget) out vec4 outDiffuse;
layout(location = normalTarget) out vec2 outNormal;

void main() {
    vec4 color = baseColor(); // a texture, before a neighbour may be discarded
    if (!isInMap()) discard;
    float depth = texelDepth();
    if (planeIndex(depth, boxExtent.z, boxSize.z) != planeNumber) discard;
    vec3 normal = texelNormal();
    float lit = texelLight(normal);
    outPosition = vec2(depth, float(texelPlane(depth, lit)));
    outDiffuse = vec4(color.rgb, lit);
    outNormal = octahedralEncode(normal);
}
