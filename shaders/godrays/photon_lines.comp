// Lines of light from the water's surface to what they meet (Papadopoulos and Papaioannou 2009, 3.4): a thread has one
// cell of the photon grid and cuts it up.
// In: beams, the scene depth map of the light. Out, two a line: from (m from the scene's origin; w: flux, in the unit of
// beams), to (w: metres).
#include "interface/bindings.glsl"
#include "water/photon_ray.glsl"
#include "godrays/ray_hit.glsl"
#include "water/surface_shadow.glsl"
layout(local_size_x = 64) in;
layout(std430, binding = photonLinesBuffer) writeonly buffer Lines { vec4 lines[]; };
layout(location = reachLocation) uniform float reach;       // m, for light that meets nothing
layout(location = farthestLocation) uniform float farthest; // m of water below which nothing lies
layout(location = testSurfaceShadowLocation) uniform int testSurfaceShadow;

void main() {
    int cell = int(gl_GlobalInvocationID.y * gl_NumWorkGroups.x * gl_WorkGroupSize.x + gl_GlobalInvocationID.x);
    if (cell >= cells.x * cells.y) return;
    int count = subdivision * subdivision;
    for (int i = 0; i < count; ++i) {
        Photon photon = photonOf(cell, i);
        float flux = photon.flux;
        if (testSurfaceShadow != 0) flux *= surfaceVisibility(photon.from, 0.0);
        float metres = flux > 0.0 ? min(metresToHit(photon.from, photon.direction, farthest, reach), reach) : 0.0;
        lines[2 * (cell * count + i)] = vec4(photon.from, flux);
        lines[2 * (cell * count + i) + 1] = vec4(photon.from + metres * photon.direction, metres);
    }
}
