// The slices as one: each texel is that of the topmost slice that has surface there, which is what the light sees first.
// Out 0, RGBA32F: irradiance, W/m². Out 1 to 3: position, diffuse and normal map as in level_map.frag.
#include "interface/bindings.glsl"
#include "caustics/slice.glsl"
layout(binding = sliceCausticsUnit) uniform sampler2DArray sliceCaustics;
layout(location = sliceCountLocation) uniform int sliceCount;
layout(location = irradianceTarget) out vec4 outIrradiance;
layout(location = positionTarget) out vec2 outPosition;
layout(location = diffuseTarget) out vec4 outDiffuse;
layout(location = normalTarget) out vec2 outNormal;

void main() {
    ivec3 texel = ivec3(gl_FragCoord.xy, 0);
    outPosition = texelFetch(slicePosition, texel, 0).xy;
    while (outPosition.y == -1.0) {
        if (++texel.z == sliceCount) discard;
        outPosition = texelFetch(slicePosition, texel, 0).xy;
    }
    outDiffuse = texelFetch(sliceDiffuse, texel, 0);
    outNormal = texelFetch(sliceNormal, texel, 0).xy;
    outIrradiance = texelFetch(sliceCaustics, texel, 0);
}
