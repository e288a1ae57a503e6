#version 450 core
layout(location = 0) in vec3 inPosition; // m, the object's own space
layout(location = 1) in vec3 inNormal;
layout(location = 0) uniform mat4 viewProjection;
layout(location = 1) uniform vec3 translation; // m
out vec3 position;
out vec3 normal;

void main() {
    position = inPosition + translation;
    normal = inNormal;
    gl_Position = viewProjection * vec4(position, 1.0);
}
