// What one beam gives a texel that the beam's intersection triangle with a plane covers (thesis 4.5, eq. 4-18 with
// Fresnel, RGB extinction along the beam, and the receiver's own cosine). For fragment shaders after drawn_plane.vert.
#include "interface/bindings.glsl"
#include "caustics/footprint.glsl"
#include "water/surface_shadow.glsl"
layout(std430, binding = beamAreasBuffer) readonly buffer BeamAreas { vec4 areas[]; };
layout(location = planeDepthLocation) uniform float planeDepth; // m
layout(location = strengthLocation) uniform vec3 strength;      // of the light, W per unit of flux
layout(location = extinctionPerMetreLocation) uniform vec3 extinctionPerMetre;
layout(location = testSurfaceShadowLocation) uniform int testSurfaceShadow; // 0: nothing stands out of the water
in vec2 slope;
in float startDepth;

// W/m² on the surface at `depth` m with `normal`, of which the share `lit` reaches the texel.
vec3 beamIrradiance(float depth, vec3 normal, float lit) {
    vec4 beam = areas[gl_PrimitiveID];
    float density = fluxPerTexel(beam.xyz, beam.w, planeDepth) / (boxExtent.w * boxExtent.w);

    // The beam's direction over its component along the axis: -n·t / |t·V| of physics is -n·along.
    vec3 along = vec3(slope, 1.0);
    float metres = (depth - startDepth) * length(along);
    lit *= max(-dot(boxDirection(normal), along), 0.0);
    if (testSurfaceShadow != 0 && lit > 0.0) {
        vec2 start = gl_FragCoord.xy * boxExtent.w - slope * (planeDepth - startDepth);
        lit *= surfaceVisibility(boxPoint(vec3(start, startDepth)), 0.0);
    }
    return strength * extinction(extinctionPerMetre, metres) * (density * lit);
}
