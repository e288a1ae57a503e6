// A picture's samples become its pixels, rows from the top.
// In: RGBA32F, linear radiance, W/(m² sr), row 0 at the bottom. Out, RGBA32F: the same; or, TONE_MAPPED, RGBA8: sRGB, dithered.
#include "interface/bindings.glsl"
#include "optics/tonemap.glsl"
#include "view/pixel_mean.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = samplesUnit) uniform sampler2D samples;
layout(location = perPixelLocation) uniform int perPixel; // samples along each axis
#ifdef TONE_MAPPED
layout(rgba8, binding = pixelsImage) writeonly uniform image2D pixels;
layout(location = gainLocation) uniform float gain; // 2 to the exposure's stops
layout(location = whiteLocation) uniform float white; // luminance that becomes white
#else
layout(rgba32f, binding = pixelsImage) writeonly uniform image2D pixels;
#endif

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy), size = imageSize(pixels);
    if (any(greaterThanEqual(pixel, size))) return;
    vec3 mean = pixelMean(samples, ivec2(pixel.x, size.y - 1 - pixel.y), perPixel);
#ifdef TONE_MAPPED
    mean = displaySteps(displayed(mean, gain, white), uvec2(pixel)) / 255.0;
#endif
    imageStore(pixels, pixel, vec4(mean, 1.0));
}
