// The receiver lit by parallel light as flat water lets it through, with its shadows: what the caustic image is
// multiplied with (Iwasaki et al. 2002, 4.3.1 and 5). Of a point light, the light that flat water would send to the texel.
// Out: share of W/m² across the light that its surface has, [0, ...].
#include "interface/bindings.glsl"
#include "levelmap/box.glsl"
#include "water/light.glsl"
#include "optics/octahedral.glsl"
layout(binding = diffuseMapUnit) uniform sampler2D diffuseMap;   // alpha: share of the mean light
layout(binding = positionMapUnit) uniform sampler2D positionMap; // RG32F
layout(binding = normalMapUnit) uniform sampler2D normalMap;     // RG16
out vec4 share;

void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy);
    vec3 point = boxPoint(vec3((vec2(texel) + 0.5) * boxExtent.w, texelFetch(positionMap, texel, 0).x));
    vec3 light = meanDirection(entryPoint(point));
    vec3 normal = octahedralDecode(texelFetch(normalMap, texel, 0).xy);
    float cosine = max(-dot(normal, light), 0.0) / max(dot(light, boxT.xyz), 0.02);
    share = vec4(cosine * texelFetch(diffuseMap, texel, 0).a);
}
