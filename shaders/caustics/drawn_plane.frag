// Adds one beam's irradiance to the texels that belong to the plane (thesis 4.5, eq. 4-18 with Fresnel, RGB
// extinction along the beam, and the receiver's own cosine).
// Out, RGBA32F, added: W/m² on the receiver's own surface.
#include "include/box.glsl"
#include "include/octahedral.glsl"
#include "include/surface_shadow.glsl"
layout(binding = 0) uniform sampler2D positionMap; // RG32F
layout(binding = 1) uniform sampler2D diffuseMap;  // alpha: share of the mean light
layout(binding = 2) uniform sampler2D normalMap;   // RG16
layout(std430, binding = 8) readonly buffer BeamAreas { vec4 areas[]; };
layout(location = 0) uniform float planeDepth;     // m
layout(location = 1) uniform int planeNumber;
layout(location = 2) uniform vec3 strength;        // of the light, W per unit of flux
layout(location = 3) uniform vec3 extinctionPerMetre;
layout(location = 4) uniform int testSurfaceShadow; // 0: nothing stands out of the water
in vec2 slope;
in float startDepth;
layout(location = 0) out vec4 irradiance;

// Rasterisers place corners on a grid of 1/256 texel and cover a texel's centre with no triangle that is smaller
// than half a cell of it, in texels; so this is no clamp of the light, it only keeps rounding from dividing by 0.
const float smallestTwiceArea = 1.0 / 65536.0;

void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy);
    vec2 position = texelFetch(positionMap, texel, 0).xy;
    if (int(position.y) != planeNumber) discard;
    vec4 beam = areas[gl_PrimitiveID];
    float twiceArea = abs(beam.x + planeDepth * (beam.y + planeDepth * beam.z));
    float density = 2.0 * beam.w / (max(twiceArea, smallestTwiceArea) * boxExtent.w * boxExtent.w);

    // The beam's direction over its component along the axis: -n·t / |t·V| of physics is -n·along.
    vec3 along = vec3(slope, 1.0);
    vec3 normal = boxDirection(octahedralDecode(texelFetch(normalMap, texel, 0).xy));
    float metres = (position.x - startDepth) * length(along);
    float lit = texelFetch(diffuseMap, texel, 0).a * max(-dot(normal, along), 0.0);
    if (testSurfaceShadow != 0 && lit > 0.0) {
        vec2 start = gl_FragCoord.xy * boxExtent.w - slope * (planeDepth - startDepth);
        lit *= surfaceVisibility(boxPoint(vec3(start, startDepth)), 0.0);
    }
    irradiance = vec4(strength * extinction(extinctionPerMetre, metres) * (density * lit), 1.0);
}
