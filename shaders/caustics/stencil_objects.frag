// The depths of what the light sees of a receiver, as the volumes' own (Iwasaki et al. 2002, 4.3.1, step 1). A texel
// keeps clear of the sample planes: its index says which sub-volume it is in.
#include "interface/bindings.glsl"
#include "caustics/sub_volumes.glsl"
layout(binding = positionMapUnit) uniform sampler2D positionMap; // RG32F

void main() {
    vec2 position = texelFetch(positionMap, ivec2(gl_FragCoord.xy), 0).xy;
    if (position.y < 0.0) discard; // the nearest depth stays, before which no face is
    vec2 depths = subVolume(int(position.y));
    float clear = 1e-3 * (depths.y - depths.x);
    gl_FragDepth = 0.5 * clipDepth(clamp(position.x, depths.x + clear, depths.y - clear)) + 0.5;
}
