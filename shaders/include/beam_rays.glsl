// The rays that a beam is split into for counting: equal flux, spread evenly over the water triangle.
#include "include/triangle.glsl"
layout(std430, binding = 0) readonly buffer Indices { uint indices[]; };
layout(std430, binding = 3) readonly buffer BeamOrigins { vec4 origins[]; };
layout(std430, binding = 4) readonly buffer BeamDirections { vec4 directions[]; };
layout(std430, binding = 6) buffer Landings { vec4 landings[]; };
layout(location = 0) uniform int rayCount;
layout(location = 1) uniform int firstTriangle;
layout(location = 3) uniform float farthest; // m of water below which nothing lies

struct Ray {
    vec3 from;      // m from the scene's origin
    vec3 direction; // unit
};

Ray beamRay(int ray) {
    int triangle = firstTriangle + ray / raysPerBeam;
    vec3 weight = trianglePoint(ray % raysPerBeam);
    vec3 from = vec3(0.0), direction = vec3(0.0);
    for (int i = 0; i < 3; ++i) {
        uint vertex = indices[3 * triangle + i];
        from += weight[i] * origins[vertex].xyz;
        direction += weight[i] * directions[vertex].xyz;
    }
    return Ray(from, normalize(direction));
}
