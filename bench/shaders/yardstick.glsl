// What the yardsticks share: rays onto one plane, half-way down a receiver's box.
#include "interface/bindings.glsl"
#include "levelmap/box.glsl"
#include "water/light.glsl"

// Where the ray from a point of the surface meets the plane, in texels of the receiver's map.
vec2 texelOf(vec3 surface, vec3 direction) {
    vec3 from = boxLocal(surface), along = boxDirection(direction);
    return (from.xy + along.xy * ((0.5 * boxExtent.z - from.z) / along.z)) / boxExtent.w;
}

vec3 refracted(vec3 surface, vec3 normal) { return refractDirection(incidentDirection(surface), normal, 1.0 / waterSurface.y); }
