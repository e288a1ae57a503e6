// A receiver in one of the six views of a point light (point_light_shadow.glsl).
#include "interface/bindings.glsl"
#include "levelmap/point_light_shadow.glsl"
#include "levelmap/receiver_vertex.glsl"
layout(location = faceLocation) uniform int face;

void main() {
    passVertex();
    vec3 way = inPosition - lightPosition.xyz;
    ivec3 axes = pointLightAxes(face);
    gl_Position = vec4(way[axes.y], way[axes.z], 0.0, face % 2 == 0 ? way[axes.x] : -way[axes.x]);
}
