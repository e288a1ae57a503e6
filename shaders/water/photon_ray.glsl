// A photon: the light of a small piece of the water's level, refracted as the beam that it goes through.
#include "interface/bindings.glsl"
layout(std430, binding = indicesBuffer) readonly buffer Indices { uint indices[]; };
layout(std430, binding = beamOriginsBuffer) readonly buffer BeamOrigins { vec4 origins[]; };
layout(std430, binding = beamDirectionsBuffer) readonly buffer BeamDirections { vec4 directions[]; };
layout(std430, binding = beamFluxBuffer) readonly buffer BeamFlux { float flux[]; };
layout(location = patchRectLocation) uniform vec4 patchRect;    // x, z of a corner and extents of the beams' grid, m
layout(location = quadsLocation) uniform ivec2 quads;           // of it
layout(location = photonRectLocation) uniform vec4 photonRect;  // of the photon grid, likewise
layout(location = cellsLocation) uniform ivec2 cells;           // of it
layout(location = subdivisionLocation) uniform int subdivision; // photons along a side of a cell

struct Photon {
    vec3 from;      // m from the scene's origin
    vec3 direction; // unit
    float flux;     // in the unit of beams
};

// The photon through a place of the level, of a piece as large as those of the grid. Quads are cut as in
// water/WaterSurface.cpp.
Photon photonAt(vec2 xz) {
    vec2 at = clamp((xz - patchRect.xy) / patchRect.zw * vec2(quads), vec2(0.0), vec2(quads) - 1e-4);
    ivec2 quad = min(ivec2(at), quads - 1);
    vec2 f = at - vec2(quad);
    vec3 w;
    bool first;
    if (((quad.x + quad.y) & 1) == 0) {
        first = f.x + f.y < 1.0; // a c b, then b c d
        w = first ? vec3(1.0 - f.x - f.y, f.y, f.x) : vec3(1.0 - f.y, 1.0 - f.x, f.x + f.y - 1.0);
    } else {
        first = f.x < f.y; // a c d, then a d b
        w = first ? vec3(1.0 - f.y, f.y - f.x, f.x) : vec3(1.0 - f.x, f.y, f.x - f.y);
    }
    int triangle = 2 * (quad.y * quads.x + quad.x) + (first ? 0 : 1);
    vec3 from = vec3(0.0), direction = vec3(0.0);
    for (int i = 0; i < 3; ++i) {
        uint vertex = indices[3 * triangle + i];
        from += w[i] * origins[vertex].xyz;
        direction += w[i] * directions[vertex].xyz;
    }
    vec2 quadSize = patchRect.zw / vec2(quads), cellSize = photonRect.zw / vec2(cells * subdivision);
    return Photon(from, normalize(direction), flux[triangle] * (cellSize.x * cellSize.y) / (0.5 * quadSize.x * quadSize.y));
}

// Photon `i` of a cell, below subdivision².
Photon photonOf(int cell, int i) {
    ivec2 number = ivec2(cell % cells.x, cell / cells.x) * subdivision + ivec2(i % subdivision, i / subdivision);
    return photonAt(photonRect.xy + (vec2(number) + 0.5) / vec2(cells * subdivision) * photonRect.zw);
}
