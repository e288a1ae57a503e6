// A receiver as a level map sees it, on the grid of places (coverage_places.glsl).
#include "interface/bindings.glsl"
#include "levelmap/box.glsl"
#include "levelmap/coverage_places.glsl"
#include "levelmap/receiver_vertex.glsl"
layout(location = placesLocation) uniform float places;        // along a texel's side
layout(location = gridPlacesLocation) uniform vec2 gridPlaces; // along u and w

void main() {
    passVertex();
    vec3 q = boxLocal(inPosition);
    vec2 place = places * leant(q.xy / boxExtent.w);
    // Depth as in level_map.vert.
    gl_Position = vec4(2.0 * place / gridPlaces - 1.0, 1.8 * (q.z / boxExtent.z - 0.5), 1.0);
}
