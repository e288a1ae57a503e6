// A receiver's dry part, projected along the light onto the flat surface.
#include "water/light.glsl"
#include "levelmap/receiver_vertex.glsl"

void main() {
    passVertex();
    float above = inPosition.y - waterSurface.x;
    // A point light projects through one point: w carries the division, and a corner over the point light is cut away.
    vec3 source = lightPosition.xyz;
    float w = isPointLight() ? source.y - inPosition.y : 1.0;
    vec2 foot = isPointLight() ? inPosition.xz * (source.y - waterSurface.x) - source.xz * above
                               : inPosition.xz - lightDirection.xz * (above / lightDirection.y);
    vec2 corner = (foot - surfaceShadowRect.xy * w) / surfaceShadowRect.zw;
    gl_Position = vec4(2.0 * corner - w, 0.0, w);
}
