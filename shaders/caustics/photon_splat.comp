// Photons through the water onto what a level map shows (Papadopoulos and Papaioannou 2009, 3.3). A thread has one cell
// of the photon grid and cuts it up; a photon is refracted as the beam that it goes through, its landing is found by
// Newton's iteration on the level map (Shah and Konttinen 2007), and its flux is shared out among the texels of a square
// splat that show the surface it landed on, so that none of it is lost over an edge.
// In: beams, level map. Out: flux sums.
#include "include/photon_place.glsl"
#include "include/photon_ray.glsl"
#include "include/surface_shadow.glsl"
#include "include/flux_sums.glsl"
layout(local_size_x = 64) in;
layout(location = 5) uniform float stepsPerFlux;
layout(location = 6) uniform vec3 extinctionPerMetre;
layout(location = 7) uniform int channels;       // 1 or 3
layout(location = 8) uniform vec4 splat;         // a and b of a + b / d in texels; the least and the greatest size
layout(location = 9) uniform int testSurfaceShadow;

const int newtonSteps = 8;
const int marchSteps = 64, halvings = 12;

// A photon in the box.
struct Ray {
    vec3 origin, direction; // m, unit
};

struct Landing {
    float metres; // from the surface; below 0: none
    ivec2 texel;
};
const Landing nowhere = Landing(-1.0, ivec2(0));

ivec2 texelOf(vec3 q) { return ivec2(floor(q.xy / boxExtent.w)); }

// The intersection with the plane of the texel that the last guess fell on is the next guess.
Landing byNewton(Ray ray) {
    float t = (0.5 * boxExtent.z - ray.origin.z) / ray.direction.z;
    for (int i = 0; i < newtonSteps; ++i) {
        ivec2 texel = texelOf(ray.origin + t * ray.direction);
        TexelPlane plane = planeAt(texel);
        if (!plane.lit) return nowhere;
        float above = metresAbove(plane, texel, ray.origin + t * ray.direction);
        float closing = ray.direction.z - dot(plane.rise, ray.direction.xy);
        if (closing < 0.02) return nowhere;
        t += above / closing;
        if (t <= 0.0) return nowhere;
        if (abs(above) < 1e-2 * boxExtent.w && texelOf(ray.origin + t * ray.direction) == texel) return Landing(t, texel);
    }
    return nowhere;
}

// Where Newton's iteration does not settle: in steps, until the ray passes from above the surface into it.
Landing byMarch(Ray ray) {
    float start = max(-0.01 * boxExtent.z - ray.origin.z, 0.0) / ray.direction.z;
    float end = (1.01 * boxExtent.z - ray.origin.z) / ray.direction.z;
    float low = start;
    for (int i = 1; i <= marchSteps; ++i) {
        float high = mix(start, end, float(i) / float(marchSteps));
        ivec2 texel = texelOf(ray.origin + high * ray.direction);
        TexelPlane plane = planeAt(texel);
        if (plane.lit && metresAbove(plane, texel, ray.origin + high * ray.direction) <= 0.0) {
            for (int k = 0; k < halvings; ++k) {
                float middle = 0.5 * (low + high);
                ivec2 there = texelOf(ray.origin + middle * ray.direction);
                TexelPlane at = planeAt(there);
                if (at.lit && metresAbove(at, there, ray.origin + middle * ray.direction) <= 0.0) high = middle, texel = there, plane = at;
                else low = middle;
            }
            float under = -metresAbove(plane, texel, ray.origin + high * ray.direction);
            // A jump is an edge that the ray passes behind, and lands on it or not with what comes further down.
            if (under < 4.0 * boxExtent.w * (1.0 + length(plane.rise))) return Landing(high, texel);
        }
        low = high;
    }
    return nowhere;
}

float overlap(float low, float high, int texel) { return clamp(min(high, float(texel + 1)) - max(low, float(texel)), 0.0, 1.0); }

// Adds a photon to the texels of its splat that show the same surface.
void deposit(Photon photon, Ray ray, Landing landing) {
    float size = clamp(splat.x + splat.y / max(landing.metres, 1e-9), splat.z, splat.w);
    vec2 middle = (ray.origin.xy + landing.metres * ray.direction.xy) / boxExtent.w;
    vec2 low = middle - 0.5 * size, high = middle + 0.5 * size;
    ivec2 first = ivec2(floor(low)), last = ivec2(floor(high));
    TexelPlane plane = planeAt(landing.texel);
    float weights = 0.0;
    for (int y = first.y; y <= last.y; ++y)
        for (int x = first.x; x <= last.x; ++x)
            if (sameSurface(ivec2(x, y), plane, landing.texel, 0.5 * size)) weights += overlap(low.x, high.x, x) * overlap(low.y, high.y, y);
    float arriving = photon.flux * texelFetch(diffuseMap, landing.texel, 0).a;
    if (testSurfaceShadow != 0) arriving *= surfaceVisibility(photon.from, 0.0);
    vec3 steps = arriving * stepsPerFlux * extinction(extinctionPerMetre, landing.metres);
    if (!(weights > 1e-6)) { // all of the square is beside the surface: its own texel has it
        for (int c = 0; c < channels; ++c) addFlux(channels * (landing.texel.y * boxSize.x + landing.texel.x) + c, steps[c]);
        return;
    }
    for (int y = first.y; y <= last.y; ++y)
        for (int x = first.x; x <= last.x; ++x) {
            float weight = overlap(low.x, high.x, x) * overlap(low.y, high.y, y);
            if (weight == 0.0 || !sameSurface(ivec2(x, y), plane, landing.texel, 0.5 * size)) continue;
            for (int c = 0; c < channels; ++c) addFlux(channels * (y * boxSize.x + x) + c, steps[c] * (weight / weights));
        }
}

void main() {
    int cell = int(gl_GlobalInvocationID.y * gl_NumWorkGroups.x * gl_WorkGroupSize.x + gl_GlobalInvocationID.x);
    if (cell >= cells.x * cells.y) return;
    for (int i = 0; i < subdivision * subdivision; ++i) {
        Photon photon = photonOf(cell, i);
        Ray ray = Ray(boxLocal(photon.from), boxDirection(photon.direction));
        if (photon.flux <= 0.0 || ray.direction.z < 0.02) continue;
        Landing landing = byNewton(ray);
        if (landing.metres < 0.0) landing = byMarch(ray);
        if (landing.metres >= 0.0) deposit(photon, ray, landing);
    }
}
