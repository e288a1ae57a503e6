// From linear radiance to a display. In the language that GLSL and C++ share.

// Reinhard et al. 2002, eq. 4, on luminance: keeps dark tones, rolls off highlights, `white` is the smallest
// luminance that becomes white. Colours linear, Rec. 709.
vec3 reinhard(vec3 color, float white) {
    float luminance = dot(color, vec3(0.2126f, 0.7152f, 0.0722f));
    if (!(luminance > 0.0f)) return vec3(0.0f);
    float shown = luminance * (1.0f + luminance / (white * white)) / (1.0f + luminance);
    return color * (shown / luminance);
}

// IEC 61966-2-1, one channel.
float srgbEncode(float linear) {
    if (linear <= 0.0031308f) return 12.92f * linear;
    return 1.055f * pow(linear, 1.0f / 2.4f) - 0.055f;
}

// sRGB, [0, 1], of linear radiance: `gain` is 2 to the exposure's stops, `white` the luminance that becomes white.
vec3 displayed(vec3 linear, float gain, float white) {
    vec3 color = clamp(reinhard(gain * linear, white), vec3(0.0f), vec3(1.0f));
    return vec3(srgbEncode(color.r), srgbEncode(color.g), srgbEncode(color.b));
}

// An even spread of [0, 1) over pixels, counted from the top left (R2 sequence, Roberts 2018): dithers without a pattern that
// the eye finds. In 32 bits behind the point, so that it is the same on both sides.
float dither(uvec2 pixel) { return float((pixel.x * 3242174889u + pixel.y * 2447445414u) >> 8u) / 16777216.0f; }

// The step of [0, 255] that a pixel shows. Values that are whole steps but for rounding stay at theirs where the dither adds
// nothing.
vec3 displaySteps(vec3 color, uvec2 pixel) { return min(floor(255.0f * color + dither(pixel) + 1e-3f), vec3(255.0f)); }
