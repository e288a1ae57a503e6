// The water's mesh, each corner moved to where its refracted ray meets the plane.
#include "../bench/shaders/yardstick.glsl"
layout(location = positionAttribute) in vec4 position; // m
layout(location = normalAttribute) in vec4 normal;
out vec2 before; // the corner's place without refraction, texels

void main() {
    before = texelOf(position.xyz, lightDirection.xyz);
    vec2 texel = texelOf(position.xyz, refracted(position.xyz, normal.xyz));
    gl_Position = vec4(2.0 * texel / vec2(boxSize.xy) - 1.0, 0.0, 1.0);
}
