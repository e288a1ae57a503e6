// Photons through the water onto what a level map shows (Papadopoulos and Papaioannou 2009, 3.3). A thread has one cell
// of the photon grid and cuts it up; a photon is refracted as the beam that it goes through, its landing is found by
// Newton's iteration on the level map (Shah and Konttinen 2007), and its flux is shared out among the texels of a square
// splat that show the surface it landed on, so that none of it is lost over an edge. What is in a photon's way is asked
// for in its own direction, in the scene depth map.
// In: beams, tangent planes, scene depth map. Out: flux sums.
#include "include/photon_place.glsl"
#include "include/photon_ray.glsl"
#include "include/occlusion.glsl"
#include "include/surface_shadow.glsl"
#include "include/flux_sums.glsl"
layout(local_size_x = 64) in;
layout(location = 5) uniform float stepsPerFlux;
layout(location = 6) uniform vec3 extinctionPerMetre;
layout(location = 7) uniform int channels;       // 1 or 3
layout(location = 8) uniform vec4 splat;         // a and b of a + b / d in texels; the least and the greatest size
layout(location = 9) uniform int testSurfaceShadow;
layout(location = 10) uniform int testOcclusion; // 0: nothing can be before the receiver
layout(location = 11) uniform int receiverNumber;

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
        if (!plane.there) return nowhere;
        float above = metresAbove(plane, texel, ray.origin + t * ray.direction);
        float closing = ray.direction.z - dot(plane.rise, ray.direction.xy);
        if (closing < 0.02) return nowhere;
        t += above / closing;
        if (t <= 0.0) return nowhere;
        if (abs(above) < 1e-2 * boxExtent.w && texelOf(ray.origin + t * ray.direction) == texel) return Landing(t, texel);
    }
    return nowhere;
}

// Whether a ray is below the surface that the texel shows which it is over.
bool isBelow(vec3 q, out ivec2 texel, out float above) {
    texel = texelOf(q);
    TexelPlane plane = planeAt(texel);
    above = plane.there ? metresAbove(plane, texel, q) : 1e30;
    return above <= 0.0;
}

// Where Newton's iteration does not settle: in steps, until the ray passes from above the surface to below it. One that
// gets below it from beside, past an edge of what the map shows, has come through something else, or behind the edge.
Landing byMarch(Ray ray) {
    float start = max(-0.01 * boxExtent.z - ray.origin.z, 0.0) / ray.direction.z;
    float end = (1.01 * boxExtent.z - ray.origin.z) / ray.direction.z;
    float low = start;
    ivec2 texel;
    float above;
    bool wasBelow = isBelow(ray.origin + low * ray.direction, texel, above);
    for (int i = 1; i <= marchSteps; ++i) {
        float high = mix(start, end, float(i) / float(marchSteps));
        bool below = isBelow(ray.origin + high * ray.direction, texel, above);
        if (below && !wasBelow) {
            float from = low, to = high;
            for (int k = 0; k < halvings; ++k) {
                float middle = 0.5 * (from + to);
                if (isBelow(ray.origin + middle * ray.direction, texel, above)) to = middle;
                else from = middle;
            }
            isBelow(ray.origin + from * ray.direction, texel, above);
            bool shown = above < 1e29;
            isBelow(ray.origin + to * ray.direction, texel, above);
            if (shown && -above < boxExtent.w * (1.0 + length(planeAt(texel).rise))) return Landing(to, texel);
        }
        wasBelow = below;
        low = high;
    }
    return nowhere;
}

// Whether something else is in the photon's way.
bool isInShade(Photon photon, Landing landing) {
    if (testOcclusion == 0) return false;
    TexelPlane plane = planeAt(landing.texel);
    vec3 point = photon.from + landing.metres * photon.direction;
    point += besideFace(octahedralDecode(texelFetch(normalMap, landing.texel, 0).xy));
    return isShaded(photon.from, point, plane.certain, length(plane.rise), receiverNumber);
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
    float arriving = photon.flux;
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
        if (landing.metres >= 0.0 && !isInShade(photon, landing)) deposit(photon, ray, landing);
    }
}
