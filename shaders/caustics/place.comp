// Which landings a level map has a texel for. Run once for each map, those along the light after the further ones, and last
// with receiverNumber -1 for the rays that no map has taken. A ray that is counted is marked -4.
// In: landings, beam origins, flux. Out, added a beam: missed, rejected, absorbed, scattered, in W, mean of R, G, B.
#include "include/box.glsl"
#include "include/octahedral.glsl"
#include "include/optics.glsl"
#include "include/triangle.glsl"
layout(local_size_x = 64) in;
layout(binding = 0) uniform sampler2D positionMap;
layout(binding = 1) uniform sampler2D diffuseMap;
layout(binding = 2) uniform sampler2D normalMap;
layout(binding = 4) uniform sampler2D coverage; // R32F (levelmap/coverage.comp)
layout(std430, binding = 0) readonly buffer Indices { uint indices[]; };
layout(std430, binding = 3) readonly buffer BeamOrigins { vec4 origins[]; };
layout(std430, binding = 5) readonly buffer BeamFlux { float flux[]; };
layout(std430, binding = 6) buffer Landings { vec4 landings[]; };
layout(std430, binding = 7) buffer Counts { vec4 counts[]; };
layout(location = 0) uniform int beamCount;
layout(location = 1) uniform int firstTriangle;
layout(location = 3) uniform int receiverNumber;
layout(location = 4) uniform vec3 strength;
layout(location = 5) uniform vec3 absorption;
layout(location = 6) uniform vec3 scattering;
layout(location = 7) uniform int meanShade; // 1: the method takes no light where the mean light is shaded

const float counted = -4.0;
const float shaded = -3.0;

// The share of light at `point` that the level map takes; -1 where no texel of the neighbourhood shows this surface,
// and at a rim where the receiver does not reach the middle of its texel.
float placedShare(vec3 point) {
    vec3 q = boxLocal(point);
    ivec2 center = ivec2(floor(q.xy / boxExtent.w));
    float share = -1.0;
    bool isInside = all(greaterThanEqual(center, ivec2(0))) && all(lessThan(center, boxSize.xy));
    if (isInside && texelFetch(positionMap, center, 0).y == -1.0 && texelFetch(coverage, center, 0).r > 0.0) return share;
    for (int i = 0; i < 9; ++i) {
        ivec2 texel = center + ivec2(i % 3 - 1, i / 3 - 1);
        if (any(lessThan(texel, ivec2(0))) || any(greaterThanEqual(texel, boxSize.xy))) continue;
        vec2 position = texelFetch(positionMap, texel, 0).xy;
        if (position.y == -1.0 || position.y == -3.0) continue;
        float facing = abs(dot(octahedralDecode(texelFetch(normalMap, texel, 0).xy), boxT.xyz));
        float slack = boxExtent.w * (4.0 + 2.0 / max(facing, 0.05));
        if (abs(position.x - q.z) > slack) continue;
        float lit = meanShade != 0 ? texelFetch(diffuseMap, texel, 0).a : 1.0;
        if (texel == center) return lit;
        share = max(share, lit);
    }
    return share;
}

// Whether a point is outside of the box around all of the receiver: the scene depth map is wider than what is in it by up
// to half a texel, and for a lamp by what its edges bend.
bool isBesideBox(vec3 point) {
    if ((boxSize.w & 7) != 0) return false;
    vec2 q = boxLocal(point).xy;
    return any(lessThan(q, vec2(0.0))) || any(greaterThan(q, boxExtent.xy));
}

void main() {
    int beam = int(gl_GlobalInvocationID.y * gl_NumWorkGroups.x * gl_WorkGroupSize.x + gl_GlobalInvocationID.x);
    if (beam >= beamCount) return;
    int triangle = firstTriangle + beam;
    vec3 perRay = strength * (flux[triangle] / float(raysPerBeam));
    vec3 from = (origins[indices[3 * triangle]].xyz + origins[indices[3 * triangle + 1]].xyz + origins[indices[3 * triangle + 2]].xyz) / 3.0;
    vec3 lost = absorption + scattering;
    vec4 sum = vec4(0.0);
    for (int i = 0; i < raysPerBeam; ++i) {
        int ray = beam * raysPerBeam + i;
        vec4 landing = landings[ray];
        bool last = receiverNumber < 0;
        if (landing.w == counted || landing.w == shaded || (!last && int(landing.w) != receiverNumber)) continue;
        if (!last && isBesideBox(landing.xyz)) {
            landings[ray].w = -1.0;
            continue;
        }
        float share = last ? 0.0 : placedShare(landing.xyz);
        if (share < 0.0) continue;
        landings[ray].w = counted;
        if (landing.w == -1.0 || landing.w == -5.0) {
            sum.x += dot(perRay, vec3(1.0 / 3.0));
            continue;
        }
        vec3 arriving = perRay * extinction(lost, distance(from, landing.xyz));
        vec3 gone = (perRay - arriving) / max(lost, vec3(1e-20));
        sum.y += (1.0 - share) * dot(arriving, vec3(1.0 / 3.0));
        sum.z += dot(gone * absorption, vec3(1.0 / 3.0));
        sum.w += dot(gone * scattering, vec3(1.0 / 3.0));
    }
    counts[triangle] += sum;
}
