// One mode of a spectrum, as it is at time 0.
#pragma once
struct Mode {
    vec2 amplitude;   // h0, complex, m
    double frequency; // 1/s, turns
};
