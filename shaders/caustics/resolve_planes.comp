// From the sums of plane_beams.comp to irradiance; leaves the sums at zero for the next map.
// In: flux sums, one or three channels; diffuse map, alpha: the share of the mean light that reaches the texel.
// Out, RGBA32F: W/m² on the receiver's own surface.
#include "interface/bindings.glsl"
#include "levelmap/box.glsl"
#include "interface/flux_sums.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = diffuseMapUnit) uniform sampler2D diffuseMap;
layout(rgba32f, binding = irradianceImage) uniform writeonly image2D irradiance;
layout(location = wattsPerStepLocation) uniform vec3 wattsPerStep; // over the area of a texel: W/m²
layout(location = channelsLocation) uniform int channels;

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(texel, boxSize.xy))) return;
    vec3 sum = takeSums(texel.y * boxSize.x + texel.x, channels);
    imageStore(irradiance, texel, vec4(sum * wattsPerStep * texelFetch(diffuseMap, texel, 0).a, 1.0));
}
