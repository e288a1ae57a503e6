// One term of the sum, prepared by plan/WaveTerms: numbers that are large in world space (time, distance
// from the origin) are reduced there in double precision.
#pragma once
struct WaveTerm {
    vec4 shape;  // amplitude m; wavenumber 1/m (noise: cells per metre); phase, radians (noise: time in its cell, [0, 1))
    vec4 place;  // cosine: unit direction in xz; circular: centre; noise: where the origin lies in its cell, [0, 1)
    ivec4 kind;  // 0 cosine, 1 circular, 2 noise; octaves; seed
    ivec4 cell;  // noise: lattice cell of the origin in x, z and of the time
};
