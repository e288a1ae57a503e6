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
