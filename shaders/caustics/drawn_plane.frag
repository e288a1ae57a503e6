// Adds one beam's irradiance to the texels of a level map that belong to the plane.
// Out, RGBA32F, added: W/m² on the receiver's own surface.
#include "interface/bindings.glsl"
#include "caustics/beam_irradiance.glsl"
#include "optics/octahedral.glsl"
layout(binding = positionMapUnit) uniform sampler2D positionMap; // RG32F
layout(binding = diffuseMapUnit) uniform sampler2D diffuseMap;   // alpha: share of the mean light
layout(binding = normalMapUnit) uniform sampler2D normalMap;     // RG16
layout(location = planeNumberLocation) uniform int planeNumber;
out vec4 irradiance;

void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy);
    vec2 position = texelFetch(positionMap, texel, 0).xy;
    if (int(position.y) != planeNumber) discard;
    vec3 normal = octahedralDecode(texelFetch(normalMap, texel, 0).xy);
    irradiance = vec4(beamIrradiance(position.x, normal, texelFetch(diffuseMap, texel, 0).a), 1.0);
}
