// A receiver as the camera sees it, for its depth alone.
#include "include/godray_frame.glsl"
#include "include/receiver_vertex.glsl"

void main() {
    passVertex();
    gl_Position = viewProjection * vec4(inPosition, 1.0);
}
