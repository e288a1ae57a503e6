// What the maps of a receiver hold of the surface at a fragment of it: one texel of a level map, or of a slice image.
#include "interface/bindings.glsl"
#include "levelmap/facing.glsl"
#include "optics/planes.glsl"
#include "levelmap/receiver_fragment.glsl"
#include "levelmap/scene_depth.glsl"
layout(location = testOcclusionLocation) uniform int testOcclusion; // 0: nothing else can be before it
layout(location = receiverNumberLocation) uniform int receiverNumber;

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

// Whether there is surface here that the map holds.
bool isInMap() {
    bool hole = isHole();
    return !hole && fragmentIn.position.y <= waterSurface.x && belongsToMap(fragmentIn.faceNormal);
}

// Depth along the light from the box's near face, m.
float texelDepth() { return boxLocal(fragmentIn.position).z; }

// Geometric, unit, facing the box's top.
vec3 texelNormal() {
    vec3 normal = fragmentIn.faceNormal;
    return dot(normal, boxT.xyz) > 0.0 ? -normal : normal;
}

// The inside of a solid, seen where the surface cuts it open: no light is in there.
bool isInside() { return (boxSize.w & 16) != 0 && dot(fragmentIn.faceNormal, boxT.xyz) > 0.0; }

// The share of the mean light that arrives, [0, 1].
float texelLight(vec3 normal) {
    if (isInside()) return 0.0;
    if (testOcclusion == 0) return 1.0;
    vec3 asked = fragmentIn.position;
    // A face along the light is its own edge in the scene depth map: ask beside it.
    if ((boxSize.w & 7) != 0) asked += normal * 2.0 * sceneDepthTexel();
    return texelVisibility(asked, normal);
}

// Index of the reference plane that a lit texel belongs to; -2 in the shade, -3 inside of a solid.
int texelPlane(float depth, float lit) {
    return lit > 0.0 ? planeIndex(depth, boxExtent.z, boxSize.z) : isInside() ? -3 : -2;
}
