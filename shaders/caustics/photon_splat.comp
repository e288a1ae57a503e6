// Photons through the water onto what a level map shows (Papadopoulos and Papaioannou 2009, 3.3). A photon is refracted as
// the beam that it goes through, its landing is found by Newton's iteration on the level map (Shah and Konttinen 2007), and
// its flux is shared out among the texels of a square splat that show the surface it landed on, so that none of it is lost
// over an edge. A photon stands for parallel rays to all of its splat; where some triangle may be in their way
// (occluders.glsl), it is left to a second pass, which asks for each texel; as is a splat of very many texels.
// In: beams, tangent planes, occluders. Out: flux sums, list of the photons left. SHADED: the second pass, over that list.
// VEILS: some occluders let part of the light through.
#include "interface/bindings.glsl"
#include "water/photon_ray.glsl"
#include "caustics/splat_shade.glsl"
#include "water/surface_shadow.glsl"
#include "interface/flux_sums.glsl"
#ifdef SHADED
layout(local_size_x = 32) in;
#else
layout(local_size_x = 64) in;
#endif
layout(location = stepsPerFluxLocation) uniform float stepsPerFlux;
layout(location = extinctionPerMetreLocation) uniform vec3 extinctionPerMetre;
layout(location = channelsLocation) uniform int channels; // 1 or 3
layout(location = splatSizesLocation) uniform vec4 splatSizes; // a and b of a + b / d in texels; the least and the greatest size
layout(location = testSurfaceShadowLocation) uniform int testSurfaceShadow;
layout(location = testOcclusionLocation) uniform int testOcclusion; // 0: nothing can be before the receiver
layout(location = receiverNumberLocation) uniform int receiverNumber;
layout(location = shadeMarksLocation) uniform int shadeMarks; // word of `sums` where marks of shaded texels begin, one each; 0: none

layout(location = firstPhotonLocation) uniform int firstPhoton; // of the first pass: subdivision² a cell
layout(location = endPhotonLocation) uniform int endPhoton;

// Texels of a splat that one invocation sees to.
const int mostAlone = 1024;
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

Splat splatOf(Ray ray, Landing landing) {
    float size = clamp(splatSizes.x + splatSizes.y / max(landing.metres, 1e-9), splatSizes.z, splatSizes.w);
    return splatAt((ray.origin.xy + landing.metres * ray.direction.xy) / boxExtent.w, size, landing.texel);
}

// The receiver's own surface is no obstacle within what its texels are off the plane.
Target targetOf(Splat square, vec3 back) {
    vec3 lean = boxT.xyz - square.plane.rise.x * boxU.xyz - square.plane.rise.y * boxW.xyz;
    vec4 plane = vec4(lean, -dot(lean, placeOf(square, middleOf(square))));
    float near = square.asOne ? 0.0 : 2.0 * square.apart;
    return Target(receiverNumber, square.plane.rise, near * normalize(back), plane, 4.0 * near + 2.0 * boxExtent.w);
}

// What a photon carries to the texels of its splat that show the same surface.
struct Deposit {
    Splat square;
    vec3 steps; // by channel, less what the water takes
    vec3 back;  // from where it lands to where it started, m
};

Photon photonNumber(int number) {
    int each = subdivision * subdivision;
    return photonOf(number / each, number % each);
}

Deposit depositOf(Photon photon, Landing landing) {
    float flux = photon.flux * (testSurfaceShadow != 0 ? surfaceVisibility(photon.from, 0.0) : 1.0);
    vec3 steps = flux * stepsPerFlux * extinction(extinctionPerMetre, landing.metres);
    return Deposit(splatOf(Ray(boxLocal(photon.from), boxDirection(photon.direction)), landing), steps, -landing.metres * photon.direction);
}

void add(ivec2 texel, vec3 amount) {
    for (int c = 0; c < channels; ++c)
        if (amount[c] > 0.0) addFlux(channels * (texel.y * boxSize.x + texel.x) + c, amount[c]);
}

// A splat all of which is beside the surface: its own texel has it.
bool isBeside(float parts) { return !(parts > 1e-6); }

#ifdef SHADED
// One work group a photon, an invocation every 32nd texel.
void main() {
    int lane = int(gl_LocalInvocationIndex);
    LeftPhoton here = left[gl_WorkGroupID.x];
    Deposit d = depositOf(photonNumber(here.number), Landing(here.metres, ivec2(here.texel % boxSize.x, here.texel / boxSize.x)));
    d.square.apart = here.apart;
    Target target = targetOf(d.square, d.back);
    ivec2 span = d.square.last - d.square.first + 1;
    int count = span.x * span.y;
    findShadows(d.square, d.back, target, here.found, here.triangles);
    bool beside = isBeside(here.parts), asOne = beside || d.square.asOne;
    vec3 share = asOne ? arrivingAt(d.square, middleOf(d.square), 0.0, d.back, target) : vec3(1.0);
    for (int i = lane; i < (beside ? min(count, 1) : count); i += 32) {
        ivec2 texel = beside ? d.square.landed : d.square.first + ivec2(i % span.x, i / span.x);
        float part = beside ? 1.0 : partOf(d.square, texel) / here.parts;
        if (part == 0.0) continue;
        if (!asOne) share = arrivingAt(d.square, vec2(texel) + 0.5, belowPlane(d.square, texel), d.back, target);
        if (shadeMarks > 0 && share == vec3(0.0)) atomicOr(sums[shadeMarks + texel.y * boxSize.x + texel.x], 1u);
        add(texel, part * d.steps * share);
    }
}
#else
void deposit(Deposit d) {
    bool beside = isBeside(d.square.parts);
    ivec2 first = beside ? d.square.landed : d.square.first, last = beside ? d.square.landed : d.square.last;
    for (int y = first.y; y <= last.y; ++y)
        for (int x = first.x; x <= last.x; ++x) {
            float part = beside ? 1.0 : partOf(d.square, ivec2(x, y)) / d.square.parts;
            if (part > 0.0) add(ivec2(x, y), part * d.steps);
        }
}

// Finds what may be in the photon's way, if anything.
void leave(int number, Landing landing, Splat square) {
    LeftPhoton entry;
    entry.parts = square.parts, entry.apart = square.apart;
    entry.number = number, entry.metres = landing.metres, entry.texel = landing.texel.y * boxSize.x + landing.texel.x;
    entry.found = foundCount <= mostShadows ? foundCount : -1;
    for (int i = 0; i < mostShadows; ++i) entry.triangles[i] = foundTriangles[i];
    uint slot = atomicAdd(leftCount, 1u);
    atomicMax(leftGroups[0], slot + 1u);
    left[slot] = entry;
}

void main() {
    int number = firstPhoton + int(gl_GlobalInvocationID.y * gl_NumWorkGroups.x * gl_WorkGroupSize.x + gl_GlobalInvocationID.x);
    if (number >= endPhoton) return;
    Photon photon = photonNumber(number);
    Ray ray = Ray(boxLocal(photon.from), boxDirection(photon.direction));
    if (photon.flux <= 0.0 || ray.direction.z < 0.02) return;
    Landing landing = byNewton(ray);
    if (landing.metres < 0.0) landing = byMarch(ray);
    if (landing.metres < 0.0) return;
    Deposit d = depositOf(photon, landing);
    for (int y = d.square.first.y; y <= d.square.last.y; ++y)
        for (int x = d.square.first.x; x <= d.square.last.x; ++x) countTexel(d.square, ivec2(x, y));
    ivec2 span = d.square.last - d.square.first + 1;
    foundCount = 0;
    bool mayBeShaded = testOcclusion != 0 && mayBeTaken(raysTo(d.square, d.back), targetOf(d.square, d.back));
    if (mayBeShaded || span.x * span.y > mostAlone) leave(number, landing, d.square);
    else deposit(d);
}
#endif
