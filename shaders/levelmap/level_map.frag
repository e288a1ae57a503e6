// Position, diffuse and normal map of a receiver in one pass (thesis 4.2.2, MRT as in figure 5-6).
// Out 0, RG32F: depth along the light from the box's near face, m; index of the reference plane, or -2 where the
//        mean light is taken by something before it and -3 where it is the inside of a solid (cleared to 0, -1: no receiver).
// Out 1, SRGB8_ALPHA8: base colour; alpha: the share of the mean light that reaches the texel.
// Out 2, RG16: geometric normal facing the box's top, octahedral.
#include "include/facing.glsl"
#include "include/octahedral.glsl"
#include "include/planes.glsl"
#include "include/scene_depth.glsl"
#include "include/receiver_fragment.glsl"
layout(location = 0) uniform int testOcclusion; // 0: nothing else can be before it
layout(location = 1) uniform int receiverNumber;
layout(location = 0) out vec2 outPosition;
layout(location = 1) out vec4 outDiffuse;
layout(location = 2) out vec2 outNormal;

// The share of the mean light that reaches the texel: four places of it, moved along the face, so that an edge of shade
// is as soft as the texel is wide and does not run in steps.
float texelVisibility(vec3 point, vec3 normal) {
    float facing = min(dot(normal, boxT.xyz), -0.1);
    float lit = 0.0;
    for (int i = 0; i < 4; ++i) {
        vec2 quarter = 0.25 * boxExtent.w * vec2((i & 1) == 0 ? -1.0 : 1.0, i < 2 ? -1.0 : 1.0);
        vec3 aside = quarter.x * boxU.xyz + quarter.y * boxW.xyz;
        lit += 0.25 * meanVisibility(point + aside - boxT.xyz * (dot(normal, aside) / facing), normal, receiverNumber);
    }
    return lit;
}

void main() {
    vec3 position = fragmentIn.position;
    if (position.y > waterSurface.x || isHole() || !belongsToMap(fragmentIn.faceNormal)) discard;
    vec3 normal = fragmentIn.faceNormal;
    if (dot(normal, boxT.xyz) > 0.0) normal = -normal;
    float depth = boxLocal(position).z;
    vec3 asked = position;
    // A face along the light is its own edge in the scene depth map: ask beside it.
    if ((boxSize.w & 7) != 0) asked += normal * 2.0 * sceneDepthTexel();
    float lit = testOcclusion != 0 ? texelVisibility(asked, normal) : 1.0;
    // The inside of a solid, seen where the surface cuts it open: no light is in there.
    bool within = (boxSize.w & 16) != 0 && dot(fragmentIn.faceNormal, boxT.xyz) > 0.0;
    if (within) lit = 0.0;
    int plane = lit > 0.0 ? planeIndex(depth, boxExtent.z, boxSize.z) : within ? -3 : -2;
    outPosition = vec2(depth, float(plane));
    outDiffuse = vec4(baseColor().rgb, lit);
    outNormal = octahedralEncode(normal);
}
