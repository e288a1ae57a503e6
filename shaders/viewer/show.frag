// A picture as a display takes it: linear radiance in, the mean of each pixel's samples tone-mapped and dithered as
// toneMapped does it (src/view/Picture.h) out, RGBA8. Two pictures side by side, or their difference.
#include "interface/bindings.glsl"
#include "optics/tonemap.glsl"

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

vec3 meanOf(sampler2D samples, ivec2 pixel) {
    vec3 sum = vec3(0.0);
    for (int y = 0; y < perPixel; ++y)
        for (int x = 0; x < perPixel; ++x)
            sum += texelFetch(samples, pixel * perPixel + ivec2(x, y), 0).rgb;
    return sum / float(perPixel * perPixel);
}

// sRGB, [0, 1].
vec3 displayed(vec3 linear) {
    vec3 color = clamp(reinhard(gain * linear, white), 0.0, 1.0);
    return vec3(srgbEncode(color.r), srgbEncode(color.g), srgbEncode(color.b));
}

// An even spread of [0, 1) over pixels, by the sequence of view/ToneMap.cpp.
float dither(ivec2 pixel) {
    vec2 fromTop = vec2(pixel.x, size.y - 1 - pixel.y);
    return fract(fract(0.7548776662466927 * fromTop.x) + fract(0.5698402909980532 * fromTop.y));
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec3 color;
    if (mode == 2)
        color = clamp(difference * abs(displayed(meanOf(first, pixel)) - displayed(meanOf(second, pixel))), 0.0, 1.0);
    else if (mode == 1 && gl_FragCoord.x > split)
        color = displayed(meanOf(second, pixel));
    else
        color = displayed(meanOf(first, pixel));
    // To a whole number of steps here: what the target would do by itself is to round to the nearest.
    shown = vec4(min(floor(255.0 * color + dither(pixel) + 1e-3), 255.0) / 255.0, 1.0);
}
