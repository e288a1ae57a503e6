// One mode of a spectrum, as it is at time 0.
#pragma once
struct Mode {
    vec2 amplitude;  // h0, complex, m
    uvec2 frequency; // turns a second: low and high word of a number in steps of 2^-48
};
