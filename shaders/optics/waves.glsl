// Height of the water surface over its mean level, and its slopes. In the language that GLSL and C++ share.

#include "interface/wave_term.glsl"

// Height in m and slopes dy/dx, dy/dz of y = a cos(k s + phase) with s = dot(direction, xz).
vec3 cosineWave(float amplitude, float k, float phase, vec2 direction, vec2 xz) {
    float angle = k * dot(direction, xz) + phase;
    vec2 slope = -amplitude * k * sin(angle) * direction;
    return vec3(amplitude * cos(angle), slope.x, slope.y);
}

// The same around a centre: s is the distance from it. At the centre itself the slope is taken as zero.
vec3 circularWave(float amplitude, float k, float phase, vec2 center, vec2 xz) {
    vec2 away = xz - center;
    float s = length(away);
    vec2 direction = s > 1e-9f ? away / s : vec2(0.0f);
    float angle = k * s + phase;
    vec2 slope = -amplitude * k * sin(angle) * direction;
    return vec3(amplitude * cos(angle), slope.x, slope.y);
}

uint latticeHash(ivec3 cell, int seed) {
    uint h = uint(cell.x) * 0x8da6b343u ^ uint(cell.y) * 0xd8163841u ^ uint(cell.z) * 0xcb1ab31fu ^ uint(seed) * 0x9e3779b9u;
    h = (h ^ (h >> 15u)) * 0x2c1b3c6du;
    h = (h ^ (h >> 12u)) * 0x297a2d39u;
    return h ^ (h >> 15u);
}

// One of the twelve edge directions of a cube, four of them twice (Perlin, "Improving noise", 2002).
vec3 latticeGradient(ivec3 cell, int seed) {
    uint h = latticeHash(cell, seed) & 15u;
    float a = (h & 1u) == 0u ? 1.0f : -1.0f;
    float b = (h & 2u) == 0u ? 1.0f : -1.0f;
    if (h < 4u || h == 12u || h == 13u) return vec3(a, b, 0.0f);
    if (h < 8u) return vec3(a, 0.0f, b);
    return vec3(0.0f, a, b);
}

// Perlin's gradient noise at `local` (any size) within lattice cell `cell`: value in about [-1, 1] and its
// derivatives by local.x and local.y (the third coordinate is time).
vec3 gradientNoise(ivec3 cell, vec3 local, int seed) {
    vec3 whole = floor(local);
    vec3 f = local - whole;
    ivec3 base = cell + ivec3(int(whole.x), int(whole.y), int(whole.z));
    vec3 fade = f * f * f * (f * (f * 6.0f - vec3(15.0f)) + vec3(10.0f));
    vec3 fadeSlope = 30.0f * f * f * (f * (f - vec3(2.0f)) + vec3(1.0f));
    vec3 sum = vec3(0.0f);
    for (int corner = 0; corner < 8; ++corner) {
        ivec3 at = ivec3(corner & 1, (corner >> 1) & 1, corner >> 2);
        vec3 gradient = latticeGradient(base + at, seed);
        float value = dot(gradient, f - vec3(at));
        float wx = at.x == 1 ? fade.x : 1.0f - fade.x;
        float wy = at.y == 1 ? fade.y : 1.0f - fade.y;
        float wz = at.z == 1 ? fade.z : 1.0f - fade.z;
        float dx = at.x == 1 ? fadeSlope.x : -fadeSlope.x;
        float dy = at.y == 1 ? fadeSlope.y : -fadeSlope.y;
        sum += vec3(wx * wy * wz * value, (dx * wy * value + wx * wy * gradient.x) * wz, (wx * dy * value + wx * wy * gradient.y) * wz);
    }
    return sum;
}

// Octaves of noise, each with half the height and half the wavelength of the one before.
vec3 noiseWave(WaveTerm term, vec2 xz) {
    vec3 sum = vec3(0.0f);
    float amplitude = term.shape.x;
    float frequency = term.shape.y;
    vec3 offset = vec3(term.place.x, term.place.y, term.shape.z);
    ivec3 cell = ivec3(term.cell.x, term.cell.y, term.cell.z);
    for (int octave = 0; octave < term.kind.y; ++octave) {
        vec3 local = vec3(offset.x + xz.x * frequency, offset.y + xz.y * frequency, offset.z);
        vec3 noise = gradientNoise(cell, local, term.kind.z + octave);
        sum += amplitude * vec3(noise.x, noise.y * frequency, noise.z * frequency);
        amplitude *= 0.5f;
        frequency *= 2.0f;
        offset *= 2.0f;
        cell *= 2;
    }
    return sum;
}

// Height in m, dy/dx, dy/dz of one term at xz, metres from the scene's origin.
vec3 waveHeightAndSlope(WaveTerm term, vec2 xz) {
    vec2 place = vec2(term.place.x, term.place.y);
    if (term.kind.x == 0) return cosineWave(term.shape.x, term.shape.y, term.shape.z, place, xz);
    if (term.kind.x == 1) return circularWave(term.shape.x, term.shape.y, term.shape.z, place, xz);
    return noiseWave(term, xz);
}
