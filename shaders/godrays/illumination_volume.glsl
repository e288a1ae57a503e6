// Illumination volumes: what lies between three neighbouring rays from the surface, and how it is cut along its length
// (Iwasaki, Dobashi and Nishita 2002, 3.1 and 3.2).
#include "interface/bindings.glsl"
#include "water/cross_section.glsl"
#include "godrays/godray_frame.glsl"
#include "water/light.glsl"
#include "optics/shaft_cuts.glsl"
layout(std430, binding = volumeRaysBuffer) readonly buffer Rays { vec4 rays[]; };
layout(std430, binding = volumeFluxBuffer) readonly buffer VolumeFlux { float volumeFlux[]; };
layout(location = acrossLocation) uniform ivec2 across; // cells
layout(location = cutsLocation) uniform int cuts; // of each volume by loss; 0: as many as it needs
layout(location = lostLocation) uniform vec3 lost; // 1/m: what pieces grow with, what counts; share of the light that may be too much

const int mostCuts = 256;

struct Ray {
    vec3 from, direction;
    float metres;
};

struct Volume {
    Ray ray[3];
    float begin, first, end; // m below the level: its highest corner, where the first of its rays ends, where the last does
};

float depthAt(Ray ray, float metres) { return waterSurface.x - ray.from.y - metres * ray.direction.y; }

// Of a ray, to a depth below the level; it begins at the surface.
float metresAt(Ray ray, float depth) { return max((ray.from.y - waterSurface.x + depth) / -ray.direction.y, 0.0); }

Volume volumeAt(int number) {
    int cell = number / 2;
    ivec2 corner = ivec2(cell % across.x, cell / across.x);
    int a = corner.y * (across.x + 1) + corner.x, c = a + across.x + 1;
    // Both triangles of a cell have the side from b to c; corners in the order of the grid.
    ivec3 corners = (number & 1) == 0 ? ivec3(a, a + 1, c) : ivec3(a + 1, c, c + 1);
    Volume volume;
    volume.begin = volume.first = 1e30;
    volume.end = -1e30;
    for (int k = 0; k < 3; ++k) {
        vec4 from = rays[2 * corners[k]];
        Ray ray = Ray(from.xyz, rays[2 * corners[k] + 1].xyz, from.w);
        volume.ray[k] = ray;
        volume.begin = min(volume.begin, depthAt(ray, 0.0));
        volume.first = min(volume.first, depthAt(ray, ray.metres));
        volume.end = max(volume.end, depthAt(ray, ray.metres));
    }
    return volume;
}

// Whether a volume has light, and all of it goes down.
bool isLit(Volume volume, int number) {
    float highest = max(volume.ray[0].direction.y, max(volume.ray[1].direction.y, volume.ray[2].direction.y));
    return volumeFlux[number] > 0.0 && highest < -1e-3 && volume.end > volume.begin;
}

int cutsOf(Volume volume) {
    return cuts > 0 ? cuts : clamp(cutsFor(volume.end - volume.begin, lost.x, lost.y, lost.z), 1, mostCuts);
}

// Whether everything between two depths lies beyond one side of the picture, or behind the camera.
bool isOutOfView(Volume volume, float from, float to) {
    bvec4 beyond = bvec4(true);
    bool behind = true;
    for (int k = 0; k < 6; ++k) {
        Ray ray = volume.ray[k % 3];
        vec3 clip = (viewProjection * vec4(ray.from + metresAt(ray, k < 3 ? from : to) * ray.direction, 1.0)).xyw;
        beyond = bvec4(beyond.x && clip.x < -clip.z, beyond.y && clip.x > clip.z, beyond.z && clip.y < -clip.z,
                       beyond.w && clip.y > clip.z);
        behind = behind && clip.z < cameraPosition.w;
    }
    return behind || any(beyond);
}

vec4 crossingOf(Ray ray) {
    vec2 slope = ray.direction.xz / -ray.direction.y;
    return vec4(ray.from.xz + slope * (ray.from.y - waterSurface.x), slope);
}

vec3 sectionOf(Volume volume) {
    return crossSection(crossingOf(volume.ray[0]), crossingOf(volume.ray[1]), crossingOf(volume.ray[2]));
}

// Below it, what only some of the rays meet.
float splitOf(Volume volume) {
    // A thousandth is no step, but the ends of rays are no better known.
    bool even = volume.first >= volume.end - 1e-3 * (volume.end - volume.begin);
    return even ? volume.end : max(volume.first, volume.begin);
}

// Cuts beside those by loss, in rising order: where the volume turns inside out, and where the first of its rays ends. At
// its end for none.
vec3 besideOf(Volume volume) {
    float split = splitOf(volume), end = volume.end;
    vec2 turns = turnsOf(sectionOf(volume));
    turns = vec2(turns.x > volume.begin ? min(turns.x, end) : end, turns.y > volume.begin ? min(turns.y, end) : end);
    turns = vec2(min(turns.x, turns.y), max(turns.x, turns.y));
    return vec3(min(split, turns.x), clamp(split, turns.x, turns.y), max(split, turns.y));
}

int piecesOf(Volume volume) {
    vec3 beside = besideOf(volume);
    return cutsOf(volume) + int(beside.x < volume.end) + int(beside.y < volume.end) + int(beside.z < volume.end);
}
