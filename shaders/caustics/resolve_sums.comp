// From summed flux to irradiance; leaves the sums at zero for the next map.
// In: flux sums, one or three channels; normal map RG16; tangent planes, which say where no receiver is: beams at its
// edge leave light there. Out, RGBA32F: W/m² on the receiver's own surface.
#include "interface/bindings.glsl"
#include "levelmap/box.glsl"
#include "interface/flux_sums.glsl"
#include "optics/octahedral.glsl"
#include "caustics/rim.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = normalMapUnit) uniform sampler2D normalMap;
layout(binding = tangentPlanesUnit) uniform sampler2D tangentPlanes; // RGBA32F
layout(rgba32f, binding = irradianceImage) uniform writeonly image2D irradiance;
layout(location = wattsPerStepLocation) uniform vec3 wattsPerStep; // over the area of a texel: W/m²
layout(location = channelsLocation) uniform int channels;

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(texel, boxSize.xy))) return;
    vec3 sum = takeSums(texel.y * boxSize.x + texel.x, channels);
    vec4 plane = texelFetch(tangentPlanes, texel, 0);
    if (plane.x >= 1e30) sum = vec3(0.0);
    // At a rim, over the area that shows the surface.
    if (isRim(plane)) sum *= float(rimPlaces * rimPlaces) / float(bitCount(placesShown(plane)));
    vec3 normal = octahedralDecode(texelFetch(normalMap, texel, 0).xy);
    // As the bake has it: the normal's 16 bits cannot say less.
    float facing = max(abs(dot(normal, boxT.xyz)), 4e-5);
    imageStore(irradiance, texel, vec4(sum * wattsPerStep * facing, 1.0));
}
