// What every vertex shader of a receiver takes and gives.
#include "interface/bindings.glsl"
layout(location = positionAttribute) in vec3 inPosition; // m from the scene's origin
layout(location = normalAttribute) in vec3 inNormal;
layout(location = uvAttribute) in vec4 inUv;
layout(location = colorAttribute) in vec4 inColor; // linear
out VertexData {
    vec3 position;
    vec3 normal;
    vec4 uv; // of the base colour; of the normal map
    vec4 color;
} vertexOut;

void passVertex() {
    vertexOut.position = inPosition;
    vertexOut.normal = inNormal;
    vertexOut.uv = inUv;
    vertexOut.color = inColor;
}
