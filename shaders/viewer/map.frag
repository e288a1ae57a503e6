// One of a receiver's maps for the eye, RGBA8: what it holds as colours, dark where there is no receiver.
#include "interface/bindings.glsl"
#include "optics/octahedral.glsl"
#include "optics/tonemap.glsl"

layout(binding = positionMapUnit) uniform sampler2D position; // of the level map: depth along the light, m; plane index, < 0: none
layout(binding = diffuseMapUnit) uniform sampler2D diffuse; // base colour; share of the mean light
layout(binding = normalMapUnit) uniform sampler2D normal; // octahedral
layout(binding = irradianceMapUnit) uniform sampler2D caustic; // irradiance, W/m²
layout(location = sizeLocation) uniform ivec2 size; // of the target, pixels
layout(location = kindLocation) uniform int kind; // 0 position, 1 diffuse, 2 normal, 3 caustic
layout(location = heightLocation) uniform float height; // of the box, m
layout(location = gainLocation) uniform float gain; // caustics: times irradiance, before tone mapping
out vec4 shown;

const float white = 4.0; // tone mapping, as in pictures

vec3 encoded(vec3 linear) { return vec3(srgbEncode(linear.r), srgbEncode(linear.g), srgbEncode(linear.b)); }

// Near to far from bright to dark; every other reference plane bluish.
vec3 depthColor(vec2 texel) {
    float bright = 1.0 - 0.85 * clamp(texel.x / height, 0.0, 1.0);
    return bright * (int(texel.y) % 2 == 1 ? vec3(0.7, 0.9, 1.0) : vec3(1.0));
}

void main() {
    // Row 0 of a map is its top; the target is shown the same way.
    vec2 at = gl_FragCoord.xy / vec2(size);
    ivec2 texel = ivec2(at * vec2(textureSize(position, 0)));
    vec2 place = texelFetch(position, texel, 0).rg;
    vec3 color = vec3(0.06);
    if (place.y > -1.5 && place.y < -0.5) {
        color = vec3(0.06);
    } else if (kind == 0) {
        color = place.y < 0.0 ? vec3(0.25, 0.1, 0.1) : depthColor(place);
    } else if (kind == 1) {
        vec4 base = texelFetch(diffuse, texel, 0);
        color = encoded(base.rgb * (0.25 + 0.75 * base.a));
    } else if (kind == 2) {
        color = 0.5 + 0.5 * octahedralDecode(texelFetch(normal, texel, 0).rg);
    } else {
        color = encoded(clamp(reinhard(gain * texelFetch(caustic, texel, 0).rgb, white), 0.0, 1.0));
    }
    shown = vec4(color, 1.0);
}
