// What a translucent receiver's surface takes of the light on it (scene/Mesh.h, transmittance), where its level map shows it.
// Out 0, RGBA16: 1 - transmittance, [0, 1] by channel.
#include "interface/bindings.glsl"
#include "levelmap/level_map_texel.glsl"
layout(binding = transmissionTextureUnit) uniform sampler2D transmissionTexture; // linear, red
layout(location = transmissionLocation) uniform float transmission;
layout(location = blendedLocation) uniform int blended; // 1: alpha is the share of the surface that is there
out vec4 outTaken;

void main() {
    vec4 color = clamp(baseColor(), 0.0, 1.0);
    vec3 through = transmission * texture(transmissionTexture, fragmentIn.uv.xy).r * color.rgb;
    if (!isInMap()) discard;
    outTaken = vec4((blended != 0 ? color.a : 1.0) * (1.0 - through), 1.0);
}
