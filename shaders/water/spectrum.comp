// A line of the inverse Fourier transform that turns a spectrum into the coefficients of a bicubic B-spline through
// the heights of its tile. Two passes: along x for each row of modes, then along z for each column of texels. A
// group has one line; what the line has no mode for is 0.
// In: modes as scene/Spectrum.h has them (WITH_TIME: the first pass, which lets them run), or the lines of the first
// pass. Out: complex lines, or the tile, R32F: m for a root mean square of 1 m; texel i is at i cells.
#include "interface/bindings.glsl"
#include "interface/wave_mode.glsl"
layout(local_size_x = 128) in;
layout(std430, binding = modesBuffer) readonly buffer Modes { Mode modes[]; };
layout(std430, binding = turnsBuffer) readonly buffer Turns { vec2 turns[]; }; // e^(2πi n / texels), n below texels / 2
layout(std430, binding = spectrumLinesBuffer) buffer Lines { vec2 lines[]; };  // mode row by texel column
layout(r32f, binding = tileImage) uniform writeonly image2D tile;
layout(location = sideLocation) uniform int side;     // modes
layout(location = texelsLocation) uniform int texels; // of the tile's side, a power of two, at most 4096
layout(location = timeLocation) uniform uvec2 time;   // s from time 0, either way: low and high word, in steps of 2^-32
layout(location = backLocation) uniform int back; // whether it is before time 0

const float tau = 6.28318530717958648;
shared vec2 line[4096];

vec2 product(vec2 a, vec2 b) { return vec2(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x); }

#ifdef WITH_TIME
// Of the turns since time 0, what is more than whole ones. In whole numbers, which lose nothing after days, and which every GPU
// has at full speed: the product has 80 places behind the point, of which 32 are kept.
float turned(uvec2 frequency) {
    uint low, high, a, b, c, d, carry, more;
    umulExtended(frequency.x, time.x, high, low);
    umulExtended(frequency.x, time.y, b, a);
    umulExtended(frequency.y, time.x, d, c);
    uint word = uaddCarry(high, a, carry);
    word = uaddCarry(word, c, more);
    uint above = b + d + frequency.y * time.y + carry + more;
    uint turn = above << 16 | word >> 16;
    return float(back != 0 ? 0u - turn : turn) / 4294967296.0;
}

// h(k, t); the mode's partner -k is point-symmetric to it.
vec2 modeAt(int column, int row) {
    if (column == 0 || row == 0) return vec2(0.0);
    Mode here = modes[row * side + column];
    vec2 there = modes[(side - row) * side + side - column].amplitude * vec2(1.0, -1.0);
    float angle = tau * turned(here.frequency);
    vec2 turn = vec2(cos(angle), sin(angle));
    return product(here.amplitude, turn * vec2(1.0, -1.0)) + product(there, turn);
}
#endif

void main() {
    int number = int(gl_WorkGroupID.x), thread = int(gl_LocalInvocationID.x);
    for (int i = thread; i < texels; i += 128) line[i] = vec2(0.0);
    barrier();
    int bits = findMSB(texels);
    for (int mode = thread; mode < side; mode += 128) {
        int wave = mode - side / 2;
#ifdef WITH_TIME
        vec2 value = modeAt(mode, number);
#else
        vec2 value = lines[mode * texels + number];
#endif
        // A spline through the samples of a wave has coefficients that are larger by what averaging takes from it.
        value *= 6.0 / (4.0 + 2.0 * cos(tau * float(wave) / float(texels)));
        line[bitfieldReverse(uint(wave & (texels - 1))) >> (32 - bits)] = value;
    }
    barrier();
    // Cooley and Tukey 1965.
    for (int stride = 1; stride < texels; stride *= 2) {
        for (int i = thread; i < texels / 2; i += 128) {
            int within = i & (stride - 1), at = 2 * i - within;
            vec2 even = line[at], odd = product(line[at + stride], turns[within * (texels / 2 / stride)]);
            line[at] = even + odd;
            line[at + stride] = even - odd;
        }
        barrier();
    }
    for (int i = thread; i < texels; i += 128) {
#ifdef WITH_TIME
        lines[number * texels + i] = line[i];
#else
        imageStore(tile, ivec2(number, i), vec4(line[i].x));
#endif
    }
}
