// A receiver seen from where the mean light enters the flat surface.
#include "interface/bindings.glsl"
#include "water/light.glsl"
#include "levelmap/receiver_vertex.glsl"
layout(location = farthestLocation) uniform float farthest; // m of water below which nothing lies

void main() {
    passVertex();
    vec3 entry = entryPoint(inPosition);
    float distance = length(inPosition - entry);
    gl_Position = vec4(2.0 * sceneDepthUv(entry) - 1.0, 1.8 * (distance / farthest - 0.5), 1.0);
}
