// Out, RG32F: metres of water along the mean light to where the solid of `sceneDepth` is entered and to where it is
// left again. A receiver that is not closed is taken for a solid where a front of it has a back behind it: most models
// have a seam open somewhere. Light that meets a closed one from inside, since the surface cuts it open there, is in it
// from the start; in a second one, from where the first one ends.
#include "include/receiver_fragment.glsl"
#include "include/solids.glsl"
layout(location = 1) uniform int receiverNumber;
layout(location = 2) uniform float farthest;
layout(location = 3) uniform ivec2 mapSize;
layout(location = 4) uniform int closed;
layout(location = 0) out vec2 outSolid;

void main() {
    vec2 first = texelFetch(sceneDepth, ivec2(gl_FragCoord.xy), 0).xy;
    vec3 entry = sceneDepthEntry(gl_FragCoord.xy / vec2(mapSize));
    vec3 direction = meanDirection(entry);
    if (dot(fragmentIn.faceNormal, direction) <= 0.0 || isHole()) discard;
    float interpolated = dot(fragmentIn.position - entry, direction);
    float exact = distanceToPlane(entry, direction, fragmentIn.facePoint, fragmentIn.faceNormal);
    float left = abs(dot(fragmentIn.faceNormal, direction)) < 0.05 ? interpolated : exact;
    bool own = int(first.y) == receiverNumber, behind = fract(first.y) > 0.25;
    // What is left no later than anything is entered, was never entered: a wall that stands on a floor through the
    // surface.
    bool inside = closed != 0 && (own ? behind : left <= first.x + 0.5 * sceneDepthTexel());
    if (!inside && (!own || behind || left < first.x)) discard;
    float ends = firstSolidEnds(ivec2(gl_FragCoord.xy));
    if (left <= ends) discard;
    outSolid = vec2(inside ? max(ends, 0.0) : first.x, left);
    gl_FragDepth = clamp(0.5 + 0.9 * (left / farthest - 0.5), 0.0, 1.0);
}
