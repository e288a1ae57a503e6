// A corner of a piece of a receiver's triangle, placed where the camera sees it.
#include "interface/bindings.glsl"
#include "view/view.glsl"
layout(triangles, equal_spacing, ccw) in;
layout(location = wayLocation) uniform int way; // straight, refracted or mirrored
in ControlData {
    vec3 position;
    vec3 normal;
    vec4 uv;
    vec4 color;
} controlIn[];
out VertexData {
    vec3 position;
    vec3 normal;
    vec4 uv;
    vec4 color;
} vertexOut;

void main() {
    vec3 w = gl_TessCoord;
    // Two triangles name an edge's corners in different orders: contracted into a*b+c, their sums would differ and leave gaps.
    precise vec3 position = w.x * controlIn[0].position + w.y * controlIn[1].position + w.z * controlIn[2].position;
    vertexOut.position = position;
    vertexOut.normal = w.x * controlIn[0].normal + w.y * controlIn[1].normal + w.z * controlIn[2].normal;
    vertexOut.uv = w.x * controlIn[0].uv + w.y * controlIn[1].uv + w.z * controlIn[2].uv;
    vertexOut.color = w.x * controlIn[0].color + w.y * controlIn[1].color + w.z * controlIn[2].color;
    gl_Position = viewClip(position, way);
}
