// The water surface: the moving grid, or the flat rest of it out to the horizon.
#include "include/view.glsl"
layout(location = 0) in vec4 inPosition; // m from the scene's origin
layout(location = 1) in vec4 inNormal;
out vec3 position;
out vec3 normal;

void main() {
    position = inPosition.xyz;
    normal = inNormal.xyz;
    gl_Position = viewProjection * vec4(position, 1.0);
}
