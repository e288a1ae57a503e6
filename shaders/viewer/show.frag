// A picture as a display takes it: linear radiance in, the mean of each pixel's samples tone-mapped and dithered as
// view/resolve.comp does it out, RGBA8. Two pictures side by side, or their difference.
#include "interface/bindings.glsl"
#include "optics/tonemap.glsl"
#include "view/pixel_mean.glsl"

layout(binding = firstRadianceUnit) uniform sampler2D first; // linear radiance, W/(m² sr), row 0 at the bottom
layout(binding = secondRadianceUnit) uniform sampler2D second; // likewise
layout(location = sizeLocation) uniform ivec2 size; // pixels
layout(location = perPixelLocation) uniform int perPixel; // samples along each axis
layout(location = gainLocation) uniform float gain; // 2 to the exposure's stops
layout(location = modeLocation) uniform int mode; // 0: first; 1: second right of `split`; 2: difference
layout(location = splitLocation) uniform float split; // pixels from the left
layout(location = differenceLocation) uniform float difference; // a difference of 1 / this of the display's range becomes white
layout(location = whiteLocation) uniform float white; // luminance that becomes white
out vec4 shown;

vec3 displayedPixel(sampler2D samples, ivec2 pixel) { return displayed(pixelMean(samples, pixel, perPixel), gain, white); }

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec3 color;
    if (mode == 2)
        color = clamp(difference * abs(displayedPixel(first, pixel) - displayedPixel(second, pixel)), 0.0, 1.0);
    else if (mode == 1 && gl_FragCoord.x > split)
        color = displayedPixel(second, pixel);
    else
        color = displayedPixel(first, pixel);
    // To a whole number of steps here: what the target would do by itself is to round to the nearest.
    shown = vec4(displaySteps(color, uvec2(pixel.x, size.y - 1 - pixel.y)) / 255.0, 1.0);
}
