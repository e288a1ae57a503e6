// To and from the axes of a receiver's oriented bounding box.
#include "interface/box_frame.glsl"

// A direction in the box's axes. Sums in place of dot(), which a compiler may contract even where it is precise: several
// programs ask this of the same rays, and must find the same texels.
vec3 boxDirection(vec3 d) {
    precise vec3 along = vec3(d.z * boxU.z + d.y * boxU.y + d.x * boxU.x, d.z * boxW.z + d.y * boxW.y + d.x * boxW.x,
                              d.z * boxT.z + d.y * boxT.y + d.x * boxT.x);
    return along;
}
// (along u, along w, depth) of a point, m.
vec3 boxLocal(vec3 point) { return boxDirection(point - boxCorner.xyz); }
vec3 boxPoint(vec3 local) {
    return boxCorner.xyz + local.x * boxU.xyz + local.y * boxW.xyz + local.z * boxT.xyz;
}
