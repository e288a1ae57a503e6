// What every fragment shader of a receiver takes: see levelmap/face.geom.
in FragmentData {
    vec3 position;
    vec3 normal;
    vec4 uv; // of the base colour; of the normal map
    vec4 color;
    flat vec3 faceNormal;
    flat vec3 facePoint;
} fragmentIn;
layout(binding = 0) uniform sampler2D baseColorTexture; // sRGB, white where the material has none
layout(location = 16) uniform vec4 baseColorFactor;     // linear
layout(location = 17) uniform float alphaCutoff;        // alpha below it is a hole; 0: no holes
layout(location = 18) uniform float normalScale;        // 0: the material has no normal map
layout(location = 21) uniform vec3 emissionFactor;      // radiance of its own, W/(m² sr), times emissionTexture

vec4 baseColor() { return baseColorFactor * fragmentIn.color * texture(baseColorTexture, fragmentIn.uv.xy); }

// Whether this point is a hole in the surface: light, shade and view go through it.
bool isHole() { return alphaCutoff > 0.0 && baseColor().a < alphaCutoff; }
