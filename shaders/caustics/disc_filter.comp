// Spreads each texel's light over the image of a part of the sun's disc.
// In: irradiance RGBA32F, W/m² on the receiver's surface; position map RG32F; normal map RG16. Out: RGBA32F, likewise.
#include "interface/bindings.glsl"
#include "levelmap/box.glsl"
#include "water/light.glsl"
#include "optics/octahedral.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = irradianceMapUnit) uniform sampler2D irradianceMap;
layout(binding = positionMapUnit) uniform sampler2D positionMap;
layout(binding = normalMapUnit) uniform sampler2D normalMap;
layout(rgba32f, binding = irradianceImage) uniform writeonly image2D spread;
// From the middle of the part of the disc to its rim, as turns of the refracted light.
layout(location = turnRightLocation) uniform vec3 turnRight;
layout(location = turnDownLocation) uniform vec3 turnDown;

// Neighbours to each side, at most: wider ellipses are sampled at every other texel, or fewer.
const int mostTaps = 8;

vec3 normalAt(ivec2 texel) { return octahedralDecode(texelFetch(normalMap, texel, 0).xy); }
float facingOf(vec3 normal) { return max(abs(dot(normal, boxT.xyz)), 4e-5); }

// Where on the tangent plane light comes that `turn` takes aside on its way of `path` m, in texels.
vec2 shiftBy(vec3 turn, vec3 normal, float path) {
    vec3 aside = path * turn;
    float along = dot(lightRefracted.xyz, normal);
    vec3 on = aside - lightRefracted.xyz * (dot(aside, normal) / (abs(along) < 0.02 ? 0.02 * (along < 0.0 ? -1.0 : 1.0) : along));
    return vec2(dot(on, boxU.xyz), dot(on, boxW.xyz)) / boxExtent.w;
}

// Weight of the neighbour `aside` texels away in the ellipse of half axes `right` and `down`, texels.
float weightOf(vec2 aside, vec2 right, vec2 down, float area) {
    float radius = sqrt(abs(area));
    // A rim that falls off over a texel widens a disc as much as this narrows it (by variances).
    float narrowed = sqrt(max(radius * radius - 0.33, 0.04));
    vec2 inDisc = vec2(aside.x * down.y - aside.y * down.x, right.x * aside.y - right.y * aside.x) / area;
    return clamp(narrowed - length(inDisc) * radius + 0.5, 0.0, 1.0);
}

// The same where the ellipse is narrower than the texels: the nine weights that have its variances along both axes.
float narrowWeightOf(vec2 aside, vec2 variance) {
    vec2 w = mix(1.0 - variance, 0.5 * variance, notEqual(aside, vec2(0.0)));
    return w.x * w.y;
}

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(texel, boxSize.xy))) return;
    vec4 own = texelFetch(irradianceMap, texel, 0);
    imageStore(spread, texel, own);
    vec2 position = texelFetch(positionMap, texel, 0).xy;
    if (position.y == -1.0) return;
    vec3 normal = normalAt(texel);
    vec3 place = boxPoint(vec3((vec2(texel) + 0.5) * boxExtent.w, position.x));
    float path = (waterSurface.x - place.y) / max(-lightRefracted.y, 1e-3);
    vec2 right = shiftBy(turnRight, normal, path), down = shiftBy(turnDown, normal, path);
    vec2 squares = right * right + down * down;
    float widest = sqrt(max(squares.x, squares.y)), area = right.x * down.y - right.y * down.x;
    if (widest < 0.05 || isnan(widest)) return;
    bool narrow = widest <= 1.0 || abs(area) < 0.25;
    // Variances of an even disc are a quarter of its radius squared.
    vec2 variance = min(0.25 * squares, 0.5);
    int stride = narrow ? 1 : (int(ceil(min(widest, 1e6))) + mostTaps - 1) / mostTaps;
    ivec2 taps = narrow ? ivec2(1) : min(ivec2(ceil(sqrt(squares) / float(stride))), mostTaps);
    vec3 inBox = boxDirection(normal);
    vec2 slope = -inBox.xy / (abs(inBox.z) < 0.01 ? 0.01 * (inBox.z < 0.0 ? -1.0 : 1.0) : inBox.z);
    vec3 sum = vec3(0.0);
    float weights = 0.0;
    for (int y = -taps.y; y <= taps.y; ++y)
        for (int x = -taps.x; x <= taps.x; ++x) {
            ivec2 at = texel + stride * ivec2(x, y);
            if (any(lessThan(at, ivec2(0))) || any(greaterThanEqual(at, boxSize.xy))) continue;
            vec2 aside = vec2(at - texel);
            float weight = narrow ? narrowWeightOf(aside, variance) : weightOf(aside, right, down, area);
            vec2 there = texelFetch(positionMap, at, 0).xy;
            // On the same surface: no farther from the tangent plane than a fold of 45° would lie.
            float off = abs(there.x - position.x - dot(slope, aside) * boxExtent.w);
            if (weight <= 0.0 || there.y == -1.0 || off > boxExtent.w * (1.0 + length(aside))) continue;
            sum += weight * texelFetch(irradianceMap, at, 0).rgb / facingOf(normalAt(at));
            weights += weight;
        }
    if (weights > 0.0) imageStore(spread, texel, vec4(sum * facingOf(normal) / weights, own.a));
}
