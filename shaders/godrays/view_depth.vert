// A receiver as the camera sees it, for its depth alone.
#include "godrays/godray_frame.glsl"
#include "levelmap/receiver_vertex.glsl"

void main() {
    passVertex();
    gl_Position = viewProjection * vec4(inPosition, 1.0);
}
