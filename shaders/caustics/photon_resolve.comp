// From the summed flux of photons to irradiance; leaves the sums at zero for the next map.
// In: flux sums, one or three channels; normal map RG16. Out, RGBA32F: W/m² on the receiver's own surface.
#include "interface/bindings.glsl"
#include "levelmap/box.glsl"
#include "interface/flux_sums.glsl"
#include "optics/octahedral.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = normalMapUnit) uniform sampler2D normalMap;
layout(rgba32f, binding = irradianceImage) uniform writeonly image2D irradiance;
layout(location = wattsPerStepLocation) uniform vec3 wattsPerStep; // over the area of a texel: W/m²
layout(location = channelsLocation) uniform int channels;
layout(location = filteredLocation) uniform int filtered; // 1: photon_filter.comp has been over the sums

float wholeSum(int index) { return float(sums[2 * index]) + 4294967296.0 * float(sums[2 * index + 1]); }

// What the filter took or added on the whole is given back evenly.
float evened(int channel) {
    int before = channels * boxSize.x * boxSize.y + min(channel, channels - 1);
    float after = wholeSum(before + channels);
    return filtered != 0 && after > 0.0 ? wholeSum(before) / after : 1.0;
}

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(texel, boxSize.xy))) return;
    vec3 sum = takeSums(texel.y * boxSize.x + texel.x, channels) * vec3(evened(0), evened(1), evened(2));
    vec3 normal = octahedralDecode(texelFetch(normalMap, texel, 0).xy);
    // As the bake has it: the normal's 16 bits cannot say less.
    float facing = max(abs(dot(normal, boxT.xyz)), 4e-5);
    imageStore(irradiance, texel, vec4(sum * wattsPerStep * facing, 1.0));
}
