// Position, diffuse and normal map of a receiver in one pass (thesis 4.2.2, MRT as in figure 5-6).
// Out 0, RG32F: depth along the light from the box's near face, m; index of the reference plane, or -2 where the
//        mean light is taken by something before it and -3 where it is the inside of a solid (cleared to 0, -1: no receiver).
// Out 1, SRGB8_ALPHA8: base colour; alpha: the share of the mean light that reaches the texel.
// Out 2, RG16: geometric normal facing the box's top, octahedral.
#include "interface/bindings.glsl"
#include "levelmap/level_map_texel.glsl"
#include "optics/octahedral.glsl"
layout(location = positionTarget) out vec2 outPosition;
layout(location = diffuseTarget) out vec4 outDiffuse;
layout(location = normalTarget) out vec2 outNormal;

void main() {
    vec3 color = baseColor().rgb;
    if (!isInMap()) discard;
    vec3 normal = texelNormal();
    float depth = texelDepth(), lit = texelLight(normal);
    outPosition = vec2(depth, float(texelPlane(depth, lit)));
    outDiffuse = vec4(color, lit);
    outNormal = octahedralEncode(normal);
}
