// To and from the axes of a receiver's oriented bounding box.
#include "interface/box_frame.glsl"

// (along u, along w, depth) of a point, m.
vec3 boxLocal(vec3 point) {
    vec3 q = point - boxCorner.xyz;
    return vec3(dot(q, boxU.xyz), dot(q, boxW.xyz), dot(q, boxT.xyz));
}
vec3 boxPoint(vec3 local) {
    return boxCorner.xyz + local.x * boxU.xyz + local.y * boxW.xyz + local.z * boxT.xyz;
}
// A direction in the box's axes.
vec3 boxDirection(vec3 d) { return vec3(dot(d, boxU.xyz), dot(d, boxW.xyz), dot(d, boxT.xyz)); }
