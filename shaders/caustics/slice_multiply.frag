// What a slice's caustics are multiplied with (thesis 5.2.1): the share of the light that its surface takes. Its colour
// comes in where the picture is made, as with every method, so that maps hold irradiance.
#include "interface/bindings.glsl"
#include "caustics/slice.glsl"
layout(location = planeNumberLocation) uniform int planeNumber;
out vec4 factor;

void main() { factor = vec4(texelFetch(sliceDiffuse, ivec3(gl_FragCoord.xy, planeNumber), 0).a); }
