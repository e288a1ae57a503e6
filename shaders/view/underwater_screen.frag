// For a camera below the surface: the underwater view itself, dimmed by the water before it.
#include "include/view.glsl"
layout(binding = 0) uniform sampler2D underwaterRadiance;
layout(binding = 1) uniform sampler2D underwaterPosition;
layout(location = 1) uniform ivec2 targetSize;
layout(location = 0) out vec4 outRadiance;

void main() {
    vec2 ndc = 2.0 * gl_FragCoord.xy / vec2(targetSize) - 1.0;
    vec2 uv = 0.5 + 0.5 * ndc * viewWater.z;
    vec4 position = texture(underwaterPosition, uv);
    gl_FragDepth = 1.0;
    if (position.w > 1e29) discard;
    vec4 clip = viewProjection * vec4(position.xyz, 1.0);
    gl_FragDepth = clamp(0.5 + 0.5 * clip.z / clip.w, 0.0, 1.0);
    outRadiance = vec4(throughWater(texture(underwaterRadiance, uv).rgb, position.w), 1.0);
}
