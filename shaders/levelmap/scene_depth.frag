// Out 0, RG32F: metres of water along the mean light to this receiver; its number, and a
// half where its face looks along the light. The exact ray of the texel is
// cut with the face's plane, since between corners a point light's rays do not interpolate.
#include "interface/bindings.glsl"
#include "levelmap/scene_depth.glsl"
#include "levelmap/receiver_fragment.glsl"
layout(location = receiverNumberLocation) uniform int receiverNumber;
layout(location = farthestLocation) uniform float farthest;
layout(location = mapSizeLocation) uniform ivec2 mapSize;
out vec2 outDepth;

void main() {
    bool hole = isHole();
    if (hole || fragmentIn.position.y > waterSurface.x) discard;
    vec3 entry = sceneDepthEntry(gl_FragCoord.xy / vec2(mapSize));
    vec3 direction = meanDirection(entry);
    float interpolated = dot(fragmentIn.position - entry, direction);
    float exact = distanceToPlane(entry, direction, fragmentIn.facePoint, fragmentIn.faceNormal);
    float distance = abs(dot(fragmentIn.faceNormal, direction)) < 0.05 ? interpolated : exact;
    bool behind = dot(fragmentIn.faceNormal, direction) > 0.0;
    outDepth = vec2(distance, float(receiverNumber) + (behind ? 0.5 : 0.0));
    gl_FragDepth = clamp(0.5 + 0.9 * (distance / farthest - 0.5), 0.0, 1.0);
}
