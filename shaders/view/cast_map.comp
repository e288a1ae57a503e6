// A caustic map made ready to be projected: what lies just outside of the receiver's outline takes its nearest
// neighbour's value, or rims would go dark.
// In: irradiance (RGBA32F), position map (RG32F). Out, RGBA32F: irradiance, W/m²; depth along the light, m (-1: none).
#include "interface/bindings.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = irradianceMapUnit) uniform sampler2D irradianceMap;
layout(binding = positionMapUnit) uniform sampler2D positionMap;
layout(rgba32f, binding = castMapImage) writeonly uniform image2D castMap;

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    ivec2 size = imageSize(castMap);
    if (any(greaterThanEqual(texel, size))) return;
    vec2 position = texelFetch(positionMap, texel, 0).xy;
    vec4 dilated = vec4(texelFetch(irradianceMap, texel, 0).rgb, position.x);
    if (position.y == -1.0) {
        vec4 sum = vec4(0.0);
        float weights = 0.0;
        for (int i = 0; i < 25; ++i) {
            ivec2 offset = ivec2(i % 5 - 2, i / 5 - 2);
            ivec2 from = texel + offset;
            if (any(lessThan(from, ivec2(0))) || any(greaterThanEqual(from, size))) continue;
            vec2 there = texelFetch(positionMap, from, 0).xy;
            if (there.y == -1.0) continue;
            float weight = exp2(-3.0 * float(dot(offset, offset)));
            sum += weight * vec4(texelFetch(irradianceMap, from, 0).rgb, there.x);
            weights += weight;
        }
        dilated = weights > 0.0 ? sum / weights : vec4(0.0, 0.0, 0.0, -1.0);
    }
    imageStore(castMap, texel, dilated);
}
