// What every fragment shader of a receiver takes: see levelmap/face.geom.
in FragmentData {
    vec3 position;
    vec3 normal;
    vec2 uv;
    flat vec3 faceNormal;
    flat vec3 facePoint;
} fragmentIn;
layout(binding = 0) uniform sampler2D baseColorTexture; // sRGB, white where the material has none
layout(location = 16) uniform vec4 baseColorFactor;     // linear

vec4 baseColor() { return baseColorFactor * texture(baseColorTexture, fragmentIn.uv); }
