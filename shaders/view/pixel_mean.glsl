// A pixel of `samples`, which hold it as perPixel · perPixel texels side by side: their mean, summed row by row from below.
vec3 pixelMean(sampler2D samples, ivec2 pixel, int perPixel) {
    float share = 1.0 / float(perPixel * perPixel);
    precise vec3 sum = vec3(0.0);
    for (int y = 0; y < perPixel; ++y)
        for (int x = 0; x < perPixel; ++x)
            sum += share * texelFetch(samples, pixel * perPixel + ivec2(x, y), 0).rgb;
    return sum;
}
