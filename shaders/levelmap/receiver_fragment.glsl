// What every fragment shader of a receiver takes: see levelmap/face.geom.
#include "interface/bindings.glsl"
in FragmentData {
    vec3 position;
    vec3 normal;
    vec4 uv; // of the base colour; of the normal map
    vec4 color;
    flat vec3 faceNormal;
    flat vec3 facePoint;
} fragmentIn;
layout(binding = baseColorTextureUnit) uniform sampler2D baseColorTexture; // sRGB, white where the material has none
layout(location = baseColorFactorLocation) uniform vec4 baseColorFactor; // linear
layout(location = alphaCutoffLocation) uniform float alphaCutoff; // alpha below it is a hole; 0: no holes
layout(location = normalScaleLocation) uniform float normalScale; // 0: the material has no normal map
layout(location = emissionFactorLocation) uniform vec3 emissionFactor; // radiance of its own, W/(m² sr), times emissionTexture

vec4 baseColor() { return baseColorFactor * fragmentIn.color * texture(baseColorTexture, fragmentIn.uv.xy); }

// Whether this point is a hole in the surface: light, shade and view go through it. Asked for before anything else may discard
// a neighbour, since a texture's level comes from how its coordinates change from fragment to fragment.
bool isHole(vec4 color) { return alphaCutoff > 0.0 && color.a < alphaCutoff; }
bool isHole() { return alphaCutoff > 0.0 && isHole(baseColor()); }
