// Of the light on a receiver, the share that its surface takes and that sheets before it leave (occlusion/TakenLight.h).
// In: that share. In and out, RGBA32F: irradiance, W/m².
#include "interface/bindings.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = shareUnit) uniform sampler2D share; // RGBA16
layout(rgba32f, binding = irradianceImage) uniform image2D irradiance;

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(texel, imageSize(irradiance)))) return;
    vec4 light = imageLoad(irradiance, texel);
    imageStore(irradiance, texel, vec4(light.rgb * texelFetch(share, texel, 0).rgb, light.a));
}
