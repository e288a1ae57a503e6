// A receiver seen along the light, in its own box.
#include "levelmap/box.glsl"
#include "levelmap/receiver_vertex.glsl"

void main() {
    passVertex();
    vec3 q = boxLocal(inPosition) / boxExtent.xyz;
    // Depth keeps clear of the clip planes, which rounding would otherwise let cut the box's own faces.
    gl_Position = vec4(2.0 * q.xy - 1.0, 1.8 * (q.z - 0.5), 1.0);
}
