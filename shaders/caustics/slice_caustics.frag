// Adds one beam's irradiance to the surface that lies in a plane's slab, as if nothing shaded it but wholly.
// Out, RGBA32F, added: W/m² on the receiver's own surface.
#include "interface/bindings.glsl"
#include "caustics/beam_irradiance.glsl"
#include "optics/octahedral.glsl"
#include "caustics/slice.glsl"
layout(location = planeNumberLocation) uniform int planeNumber;
out vec4 irradiance;

void main() {
    ivec3 texel = ivec3(gl_FragCoord.xy, planeNumber);
    vec2 position = texelFetch(slicePosition, texel, 0).xy;
    if (int(position.y) != planeNumber) discard;
    irradiance = vec4(beamIrradiance(position.x, octahedralDecode(texelFetch(sliceNormal, texel, 0).xy), 1.0), 1.0);
}
