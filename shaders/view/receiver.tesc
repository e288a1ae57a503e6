// Splits an edge seen through the surface so finely that its curve stays within a fraction of a pixel in practice:
// pieces of at most a twelfth of the distance from the camera.
#include "interface/bindings.glsl"
#include "view/view.glsl"
layout(vertices = 3) out;
layout(location = wayLocation) uniform int way; // straight, refracted or mirrored
in VertexData {
    vec3 position;
    vec3 normal;
    vec4 uv;
    vec4 color;
} vertexIn[];
out ControlData {
    vec3 position;
    vec3 normal;
    vec4 uv;
    vec4 color;
} controlOut[];

float pieces(vec3 a, vec3 b) {
    if (way != refracted) return 1.0;
    float far = max(min(distance(a, cameraPosition.xyz), distance(b, cameraPosition.xyz)), 1e-6);
    return clamp(12.0 * distance(a, b) / far, 1.0, 64.0);
}

void main() {
    controlOut[gl_InvocationID].position = vertexIn[gl_InvocationID].position;
    controlOut[gl_InvocationID].normal = vertexIn[gl_InvocationID].normal;
    controlOut[gl_InvocationID].uv = vertexIn[gl_InvocationID].uv;
    controlOut[gl_InvocationID].color = vertexIn[gl_InvocationID].color;
    if (gl_InvocationID != 0) return;
    vec3 a = vertexIn[0].position, b = vertexIn[1].position, c = vertexIn[2].position;
    gl_TessLevelOuter[0] = pieces(b, c);
    gl_TessLevelOuter[1] = pieces(c, a);
    gl_TessLevelOuter[2] = pieces(a, b);
    gl_TessLevelInner[0] = max(gl_TessLevelOuter[0], max(gl_TessLevelOuter[1], gl_TessLevelOuter[2]));
}
