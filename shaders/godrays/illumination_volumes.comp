// Illumination volumes (Iwasaki, Dobashi and Nishita 2002, 3.1): the rays at the corners of the grid, followed to what they
// meet, and the light between every three. A thread has one corner, and the two triangles of the cell that begins there.
// In: beams, the scene depth map of the light. Out, two a corner: from (m from the scene's origin; w: metres), direction
// (unit). Out, one a triangle: flux, in the unit of beams.
#include "interface/bindings.glsl"
#include "water/photon_ray.glsl"
#include "godrays/ray_hit.glsl"
#include "water/surface_shadow.glsl"
layout(local_size_x = 64) in;
layout(std430, binding = volumeRaysBuffer) writeonly buffer Rays { vec4 rays[]; };
layout(std430, binding = volumeFluxBuffer) writeonly buffer VolumeFlux { float volumeFlux[]; };
layout(location = reachLocation) uniform float reach;       // m, for light that meets nothing
layout(location = farthestLocation) uniform float farthest; // m of water below which nothing lies
layout(location = testSurfaceShadowLocation) uniform int testSurfaceShadow;

// Three samples, each for a third.
float fluxThrough(vec2 a, vec2 b, vec2 c) {
    float sum = 0.0;
    for (int i = 0; i < 3; ++i) {
        Photon photon = photonAt((a + b + c + 3.0 * (i == 0 ? a : i == 1 ? b : c)) / 6.0);
        sum += photon.flux * (testSurfaceShadow != 0 ? surfaceVisibility(photon.from, 0.0) : 1.0);
    }
    return sum / 6.0; // that was for a whole cell
}

void main() {
    int index = int(gl_GlobalInvocationID.y * gl_NumWorkGroups.x * gl_WorkGroupSize.x + gl_GlobalInvocationID.x);
    ivec2 across = cells * subdivision, corner = ivec2(index % (across.x + 1), index / (across.x + 1));
    if (corner.y > across.y) return;
    vec2 size = photonRect.zw / vec2(across), a = photonRect.xy + vec2(corner) * size;
    Photon photon = photonAt(a);
    float metres = min(metresToHit(photon.from, photon.direction, farthest, reach), reach);
    rays[2 * index] = vec4(photon.from, metres);
    rays[2 * index + 1] = vec4(photon.direction, 0.0);
    if (any(equal(corner, across))) return;
    vec2 b = a + vec2(size.x, 0.0), c = a + vec2(0.0, size.y), d = a + size;
    int cell = corner.y * across.x + corner.x;
    volumeFlux[2 * cell] = fluxThrough(a, b, c);
    volumeFlux[2 * cell + 1] = fluxThrough(b, c, d);
}
