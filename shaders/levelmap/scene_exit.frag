// Out, R32F: metres of water along the mean light to where the solid that it hits first is left again. Drawn for
// closed receivers only, and only behind their own first hit.
#include "include/scene_depth.glsl"
#include "include/receiver_fragment.glsl"
layout(location = 1) uniform int receiverNumber;
layout(location = 2) uniform float farthest;
layout(location = 3) uniform ivec2 mapSize;
layout(location = 0) out float outDepth;

void main() {
    vec2 first = texelFetch(sceneDepth, ivec2(gl_FragCoord.xy), 0).xy;
    vec3 entry = sceneDepthEntry(gl_FragCoord.xy / vec2(mapSize));
    vec3 direction = meanDirection(entry);
    if (int(first.y) != receiverNumber || dot(fragmentIn.faceNormal, direction) <= 0.0) discard;
    float interpolated = dot(fragmentIn.position - entry, direction);
    float exact = distanceToPlane(entry, direction, fragmentIn.facePoint, fragmentIn.faceNormal);
    outDepth = abs(dot(fragmentIn.faceNormal, direction)) < 0.05 ? interpolated : exact;
    if (outDepth < first.x) discard;
    gl_FragDepth = clamp(0.5 + 0.9 * (outDepth / farthest - 0.5), 0.0, 1.0);
}
