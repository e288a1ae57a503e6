// Adds a beam's irradiance to what lies inside of one of its sub-volumes: front faces draw, where stencil and depth test
// let them; back faces mark the stencil only. In place of the paper's shading from sample plane to sample plane, the
// flux ratio is that at the texel's own depth, which a map has.
// Out, RGBA32F, added: W/m² across the light.
#include "interface/bindings.glsl"
#include "caustics/footprint.glsl"
#include "water/surface_shadow.glsl"
layout(binding = positionMapUnit) uniform sampler2D positionMap; // RG32F
layout(std430, binding = beamAreasBuffer) readonly buffer BeamAreas { vec4 areas[]; };
layout(location = strengthLocation) uniform vec3 strength; // of the light, W per unit of flux
layout(location = extinctionPerMetreLocation) uniform vec3 extinctionPerMetre;
layout(location = testSurfaceShadowLocation) uniform int testSurfaceShadow; // 0: nothing stands out of the water
out vec4 irradiance;
in vec2 slope;
in float startDepth;
flat in int beam;

void main() {
    irradiance = vec4(0.0);
    if (!gl_FrontFacing) return;
    float depth = texelFetch(positionMap, ivec2(gl_FragCoord.xy), 0).x;
    vec4 section = areas[beam];
    float amount = fluxPerTexel(section.xyz, section.w, depth) / (boxExtent.w * boxExtent.w);
    if (testSurfaceShadow != 0) {
        vec2 start = gl_FragCoord.xy * boxExtent.w - slope * (depth - startDepth);
        amount *= surfaceVisibility(boxPoint(vec3(start, startDepth)), 0.0);
    }
    float metres = (depth - startDepth) * length(vec3(slope, 1.0));
    irradiance = vec4(strength * extinction(extinctionPerMetre, metres) * amount, 1.0);
}
