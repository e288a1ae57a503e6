// What passes through a triangle that is not opaque all over: holes of cut-outs, and sheets that let part of the light on
// (scene/Mesh.h, transmittance). Images as the loaders have them: 8 bits, sRGB, filtered as the material asks.
#include "interface/bindings.glsl"
#include "interface/occluders.glsl"
layout(std430, binding = veilTrianglesBuffer) readonly buffer VeilTriangles { VeilTriangle veilTriangles[]; };
layout(std430, binding = veilMaterialsBuffer) readonly buffer VeilMaterials { uint veilWords[]; }; // twelve a material; then texels, RGBA8

int wrapped(int i, int count, int wrap) {
    if (wrap == 2) return clamp(i, 0, count - 1);
    int period = wrap == 1 ? 2 * count : count;
    int within = i % period;
    within += within < 0 ? period : 0;
    return within < count ? within : period - 1 - within;
}

// As the file has it.
vec4 veilTexel(int image, ivec2 at) {
    ivec2 size = ivec2(veilWords[image + 1], veilWords[image + 2]);
    int wraps = int(veilWords[image + 3]);
    ivec2 place = ivec2(wrapped(at.x, size.x, wraps & 3), wrapped(at.y, size.y, (wraps >> 2) & 3));
    vec4 encoded = unpackUnorm4x8(veilWords[int(veilWords[image]) + place.y * size.x + place.x]);
    if ((wraps & 32) == 0) return encoded;
    vec3 linear = mix(pow((encoded.rgb + 0.055) / 1.055, vec3(2.4)), encoded.rgb / 12.92, lessThanEqual(encoded.rgb, vec3(0.04045)));
    return vec4(linear, encoded.a);
}

// The image whose words begin at `image`; white where there is none.
vec4 veilImage(int image, vec2 uv) {
    if (int(veilWords[image]) < 0) return vec4(1.0);
    vec2 at = clamp(uv * vec2(veilWords[image + 1], veilWords[image + 2]), -1e9, 1e9);
    if ((veilWords[image + 3] & 16u) != 0u) return veilTexel(image, ivec2(floor(at)));
    vec2 low = floor(at - 0.5), part = at - 0.5 - low;
    ivec2 place = ivec2(low);
    return mix(mix(veilTexel(image, place), veilTexel(image, place + ivec2(1, 0)), part.x),
               mix(veilTexel(image, place + ivec2(0, 1)), veilTexel(image, place + ivec2(1, 1)), part.x), part.y);
}

// Whether it is more than a surface with holes.
bool isSheet(int veil) {
    int material = 12 * veilTriangles[veil].material;
    return veilWords[material + 2] != 0u || uintBitsToFloat(veilWords[material + 1]) > 0.0;
}

// The share of light that goes on behind a place of a triangle, [0, 1]; `weights` of its corners.
vec3 passingVeil(int veil, vec3 weights) {
    VeilTriangle triangle = veilTriangles[veil];
    int material = 12 * triangle.material;
    vec2 uv = weights.x * triangle.uvs[0] + weights.y * triangle.uvs[1] + weights.z * triangle.uvs[2];
    vec4 color = weights.x * triangle.colors[0] + weights.y * triangle.colors[1] + weights.z * triangle.colors[2];
    color = clamp(color * veilImage(material + baseImage, uv), 0.0, 1.0);
    if (color.a < uintBitsToFloat(veilWords[material])) return vec3(1.0);
    float transmission = uintBitsToFloat(veilWords[material + 1]) * veilImage(material + transmissionImage, uv).r;
    vec3 through = transmission * color.rgb;
    return veilWords[material + 2] != 0u ? 1.0 - color.a * (1.0 - through) : through;
}
