// What every vertex shader of a receiver takes and gives.
layout(location = 0) in vec3 inPosition; // m from the scene's origin
layout(location = 1) in vec3 inNormal;
layout(location = 2) in vec2 inUv;
out VertexData {
    vec3 position;
    vec3 normal;
    vec2 uv;
} vertexOut;

void passVertex() {
    vertexOut.position = inPosition;
    vertexOut.normal = inNormal;
    vertexOut.uv = inUv;
}
