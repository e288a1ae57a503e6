// A receiver's triangles that reach into the slab of one plane.
#include "interface/bindings.glsl"
#include "levelmap/box.glsl"
#include "levelmap/face.glsl"
#include "optics/planes.glsl"
layout(location = planeNumberLocation) uniform int planeNumber;

// Never drops a fragment that the slab takes: depths are compared with more slack than 64 times their rounding.
bool reachesSlab() {
    vec3 depths = vec3(boxLocal(vertexIn[0].position).z, boxLocal(vertexIn[1].position).z, boxLocal(vertexIn[2].position).z);
    float slack = 4e-6 * (length(boxCorner.xyz) + length(boxExtent.xyz));
    float first = min(depths.x, min(depths.y, depths.z)) - slack, last = max(depths.x, max(depths.y, depths.z)) + slack;
    return planeIndex(first, boxExtent.z, boxSize.z) <= planeNumber && planeNumber <= planeIndex(last, boxExtent.z, boxSize.z);
}

void main() {
    if (reachesSlab()) passFace();
}
